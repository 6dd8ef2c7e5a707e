/* study_tolerance.h -- the tunable numbers of what a scene asks for. */
#pragma once

#include "slow_tolerance.h"

/* The largest distance between two stored rows of a branch, in ln v or ln psi;
 * a reader's Hermite interpolation is within TOL_SAME of the curve. */
#define TOL_ROW_SPACING 0.5

/* Curves run on beyond the window by this much of its width. */
#define TOL_WINDOW_MARGIN 0.1

/* Conditioning (conditioning.c), of numbers to TOL_RTOL_DEFAULT: the first
 * change of an input, relative, a fold further than ten times that away;
 * smaller by TOL_RETRY at a time, down to that accuracy.  Two differences are
 * alike when they differ by less than BEND, or by ten times that accuracy; a
 * derivative is trusted to TRUST. */
#define TOL_CONDITION_NUDGE 1e-7
#define TOL_CONDITION_BEND  0.1
#define TOL_CONDITION_TRUST 1e-2

/* The power series in v (taylor_series.c).  Order 14 agrees with the curve
 * while it is this near, relative (an eye sees no less in a figure), to
 * TOL_ORBIT_RTOL; and tests of the radius that differ by more than a factor
 * SETTLED say that the ratios have no line yet. */
#define TOL_TAYLOR_AGREE   0.01
#define TOL_TAYLOR_SETTLED 2.0
