/* formula_tolerance.h -- what the room's algorithms stop at. */
#pragma once

#include "tolerance.h"

/* Boxes are not parted once their sides are below TOL_BOX_LEAST of the window's
 * plus TOL_BOX_LEAST_PART of their place: where two zeros meet, f ~ s^2 drowns
 * in rounding, 2^-53, for s < 1e-8, and smaller boxes decide nothing. */
#define TOL_BOX_LEAST      1e-11
#define TOL_BOX_LEAST_PART 4e-10

/* Work of a search, in additions of intervals (interval.h, effort): a second
 * or so. */
#define TOL_SEARCH_EFFORT 20000000L

/* A zero is settled in boxes of this part of its size and of its last Newton
 * step, widened by TOL_SETTLE_GROWTH as long as K is not inside: K < X. */
#define TOL_SETTLE_PART   0x1p-100
#define TOL_SETTLE_GROWTH 1024

/* A side is parted for what it changes in the equations where that differs by
 * more than this, of 2 in all, from what the other changes. */
#define TOL_BOX_DECIDES 0.25

/* A period is typed with so many digits: rates after it are the same to this
 * part of their slopes and values, places to this part of it. */
#define TOL_PERIODIC 1e-25
