/*
 * slow_fit.h -- the polynomials between the knots of a slow branch
 * (slow_branch.h): their curvatures, and how far off they are.
 */
#ifndef SLOW_SLOW_FIT_H
#define SLOW_SLOW_FIT_H

#include "slow_branch.h"

/* The curvatures of knots where those of the field are noise.  Time and slip of
 * a knot are still what its step gained, negative. */
void slow_fit_smooth(struct slow_branch *b);

/* Time and slip errors of the intervals, by what polynomials over two steps
 * miss; time and slip are what is still to come. */
void slow_fit_judge(struct slow_branch *b);

#endif
