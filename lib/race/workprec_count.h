/* workprec_count.h -- a planar system that counts how often it is asked, for
 * what does not count itself. */
#pragma once

#include "planar.h"

struct workprec_counter {
    struct planar system;        /* the one counted; its ctx borrowed */
    size_t *calls;               /* borrowed */
    struct planar_steady steady; /* set by workprec_counted */
};

/* c->system, with fields, Jacobians and coefficients of jets counted; borrows
 * c. For one thread. */
struct planar workprec_counted(struct workprec_counter *c);
