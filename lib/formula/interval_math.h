/*
 * interval_math.h -- functions of intervals of 64 bits with proof: made of
 * interval_point.h's at their ends.  No rounding mode is ever changed.
 *
 * An end that is not finite says nothing; intervals are never empty.
 */
#pragma once

#include <math.h>

#include "interval_long.h"
#include "jet.h"

static inline struct interval interval_point(long double x)
{
    return (struct interval){ x, x };
}

/* [-r, r] of the larger |end| of u. */
static inline long double interval_most(struct interval u)
{
    return fmaxl(fabsl(u.lo), fabsl(u.hi));
}

/* The least |x| of u. */
static inline long double interval_least(struct interval u)
{
    return u.lo > 0 ? u.lo : u.hi < 0 ? -u.hi : 0;
}

static inline struct interval interval_within(long double r)
{
    return (struct interval){ -r, r };
}

/* The doubles at it or beyond. */
static inline double interval_up(long double x)
{
    const double d = (double) x;

    return d < x ? nextafter(d, HUGE_VAL) : d;
}

static inline double interval_down(long double x)
{
    return -interval_up(-x);
}

static inline struct interval_double interval_outward(struct interval u)
{
    return (struct interval_double){ interval_down(u.lo), interval_up(u.hi) };
}

static inline struct interval interval_of_double(struct interval_double u)
{
    return (struct interval){ u.lo, u.hi };
}

/* About. */
static inline double interval_middle(struct interval u)
{
    return (double) (u.lo / 2 + u.hi / 2);
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
    return (struct interval){ fminl(u.lo, w.lo), fmaxl(u.hi, w.hi) };
}

/* Of two enclosures of the same numbers. */
static inline struct interval interval_both(struct interval u,
                                            struct interval w)
{
    return (struct interval){ fmaxl(u.lo, w.lo), fminl(u.hi, w.hi) };
}

static inline struct interval interval_low(struct interval u)
{
    return interval_point(u.lo);
}

static inline struct interval interval_high(struct interval u)
{
    return interval_point(u.hi);
}

static inline bool interval_is_zero(struct interval u)
{
    return u.lo >= 0 && u.hi <= 0;
}

/* Intervals and what sums of products need of them, in doubles, which are read
 * four times as fast: of c[k] twice the middle is within half[k] of high + low,
 * as twice half its width. */
struct interval_row {
    const struct interval *c; /* borrowed */
    double high[JET_SIZE], low[JET_SIZE], half[JET_SIZE];
};

/* Takes c[k], and all from 0 to n. */
void interval_row_take(struct interval_row *r, size_t k);
struct interval_row interval_row_of(const struct interval c[], size_t n);

/* sum over i < n of (1 + rise i) u[first + i] w[top - i], over a number > 0. */
struct interval interval_sum(size_t n, int rise, const struct interval_row *u,
                             size_t first, const struct interval_row *w,
                             size_t top, long double over);

/* Coefficient k > 0 of w with w' = d u'. */
struct interval interval_chain(const struct interval_row *u,
                               const struct interval_row *d, size_t k);

/* Series to order n: e^u of what is e0 at order 0, and u w. */
void interval_exponential(size_t n, const struct interval u[],
                          struct interval e0, struct interval out[]);
void interval_product(size_t n, const struct interval u[],
                      const struct interval w[], struct interval out[]);

struct interval interval_exp(struct interval u);
struct interval interval_expm1(struct interval u);
struct interval interval_ln(struct interval u);   /* of what is > 0 */
struct interval interval_ln1p(struct interval u); /* of what is > -1 */
struct interval interval_sqrt(struct interval u); /* of what is >= 0 */
struct interval interval_sinh(struct interval u);
struct interval interval_asinh(struct interval u);

/* u^n of n >= 0 */
struct interval interval_power(struct interval u, long n);

/* asinh(e^u/2) */
struct interval interval_asinh_exp(struct interval u);

/* ln(k e^u + q) with k + q = 1, k and q >= 0, and its derivative by u. */
struct interval interval_mixed(struct interval k, struct interval q,
                               struct interval u);
struct interval interval_mixed_slope(struct interval k, struct interval q,
                                     struct interval u);

/* asinh(e^(k + u)/2) - asinh(e^k/2) */
struct interval interval_friction(struct interval k, struct interval u);
