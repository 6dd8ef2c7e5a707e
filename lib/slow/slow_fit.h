/*
 * slow_fit.h -- the polynomials between the knots of a slow branch
 * (slow_branch.h): their curvatures, the friction on them, how far off they
 * are, and what rounding does.
 */
#pragma once

#include "slow_branch.h"

/* The curvatures of knots where those of the field are noise.  Time and slip of
 * a knot are still what its step gained, negative. */
void slow_fit_smooth(struct slow_branch *b);

/* From eigenvectors to fibres, off by what they turn within a fold.  Time of a
 * knot is still what its step gained. */
void slow_fit_fibres(struct slow_branch *b);

/* How far the curve, an orbit from its first knot, is beside its polynomials.
 * Time of a knot is still what its step gained. */
void slow_fit_places(const struct slider *s, struct slow_branch *b);

/* The largest friction on the way to each knot, and the peaks to come.  Where
 * steps are short the curve is better than what they say between their ends,
 * off it, where friction balances gravity.  b->end_aside is known. */
void slow_fit_frictions(const struct slider *s, struct slow_branch *b);

/* Errors of the intervals, by what polynomials over two steps miss: of time and
 * slip, which are what is still to come, and of friction. */
void slow_fit_judge(const struct slider *s, struct slow_branch *b);

/* Each step rounds the place where it ends, and what is to come with that: its
 * errors, independent of each other, add up from the branch's end or from its
 * face on. */
void slow_fit_digits(struct slow_branch *b);
