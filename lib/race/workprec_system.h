/*
 * workprec_system.h -- the block's equations as a careful user writes them for
 * a library: in the chart of ln v and ln psi, where nothing overflows.
 *
 * Backward in the arc length of the chart, du/ds = -f/|f|, with the slip in
 * excess of the saddle's as a third component if asked for; or forward in time,
 * du/dt = f, with the slip.
 */
#ifndef RACE_WORKPREC_SYSTEM_H
#define RACE_WORKPREC_SYSTEM_H

#include "method.h"
#include "planar.h"

/* Both borrow sys. */
struct method_system workprec_arc(const struct planar *sys, bool excess);
struct method_system workprec_motion(const struct planar *sys, bool slip);

#endif
