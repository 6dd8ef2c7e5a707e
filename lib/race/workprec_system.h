/*
 * workprec_system.h -- the block's equations as a careful user writes them for
 * a library: in the chart of ln v and ln psi, where nothing overflows.
 */
#pragma once

#include "method.h"
#include "planar.h"

enum { WORKPREC_ALONE = -1 };

struct workprec_system {
    const struct planar *planar; /* borrowed */
    bool arc; /* backward in the arc length of the chart, du/ds = -f/|f|; else
                 forward in time, du/dt = f */
    int observable; /* of the planar system, whose integral is a third
                       component; WORKPREC_ALONE: none */
};

/* Borrows w. */
struct method_system workprec_method_system(const struct workprec_system *w);
