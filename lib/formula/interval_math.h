/*
 * interval_math.h -- functions of intervals of doubles with proof: each end is
 * MPFR's, which is correctly rounded (Fousse et al., ACM Trans. Math. Softw.
 * 33 (2007) 13), outward.  No rounding mode is ever changed.
 *
 * An end that is not finite says nothing; intervals are never empty.
 */
#pragma once

#include <math.h>

#include "interval.h"

static inline struct interval interval_point(double x)
{
    return (struct interval){ x, x };
}

/* [-r, r] of the larger |end| of u. */
static inline double interval_most(struct interval u)
{
    return fmax(fabs(u.lo), fabs(u.hi));
}

/* The least |x| of u. */
static inline double interval_least(struct interval u)
{
    return u.lo > 0 ? u.lo : u.hi < 0 ? -u.hi : 0;
}

static inline struct interval interval_within(double r)
{
    return (struct interval){ -r, r };
}

static inline double interval_middle(struct interval u)
{
    return u.lo / 2 + u.hi / 2;
}

static inline bool interval_is_finite(struct interval u)
{
    return isfinite(u.lo) && isfinite(u.hi);
}

static inline struct interval interval_minus(struct interval u)
{
    return (struct interval){ -u.hi, -u.lo };
}

static inline struct interval interval_hull(struct interval u,
                                            struct interval w)
{
    return (struct interval){ fmin(u.lo, w.lo), fmax(u.hi, w.hi) };
}

/* Of two enclosures of the same numbers. */
static inline struct interval interval_both(struct interval u,
                                            struct interval w)
{
    return (struct interval){ fmax(u.lo, w.lo), fmin(u.hi, w.hi) };
}

static inline struct interval interval_low(struct interval u)
{
    return interval_point(u.lo);
}

static inline struct interval interval_high(struct interval u)
{
    return interval_point(u.hi);
}

struct interval interval_exp(struct interval u);
struct interval interval_expm1(struct interval u);
struct interval interval_ln(struct interval u);   /* of what is > 0 */
struct interval interval_ln1p(struct interval u); /* of what is > -1 */
struct interval interval_sqrt(struct interval u); /* of what is >= 0 */
struct interval interval_sinh(struct interval u);
struct interval interval_asinh(struct interval u);

/* asinh(e^u/2) */
struct interval interval_asinh_exp(struct interval u);

/* ln(k e^u + q) with k + q = 1, k and q >= 0, and its derivative by u. */
struct interval interval_mixed(struct interval k, struct interval q,
                               struct interval u);
struct interval interval_mixed_slope(struct interval k, struct interval q,
                                     struct interval u);

/* asinh(e^(k + u)/2) - asinh(e^k/2) */
struct interval interval_friction(struct interval k, struct interval u);
