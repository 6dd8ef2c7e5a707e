/*
 * elementary_lanes.h -- functions of elementary.c over the lanes of a pair
 * (jet.h), to the same bits: the same operations in the same order, and where a
 * function has branches, all of them and a choice.  They hold where the
 * comment says; elsewhere, and for what is no number, lanes are left to the
 * plain functions.
 */
#pragma once

#include <math.h>
#include <stdbool.h>
#include <stdint.h>

#include "elementary_table.h"
#include "jet.h"

typedef uint64_t each_bits __attribute__((vector_size(8 * JET_LANES)));

static inline bool each_any(jet_mask mask)
{
    int64_t any = 0;

    for (int l = 0; l < JET_LANES; l++)
        any |= mask[l];
    return any != 0;
}

/* All lanes. */
static inline jet_mask each_all(void)
{
    return JET_PAIR(0.0) < JET_PAIR(1.0);
}

static inline jet_pair each_size(jet_pair x)
{
    return (jet_pair) ((each_bits) x & INT64_MAX);
}

/* |x| with the sign of s. */
static inline jet_pair each_signed(jet_pair x, jet_pair s)
{
    return (jet_pair) (((each_bits) x & INT64_MAX) |
                       ((each_bits) s & ~(uint64_t) INT64_MAX));
}

static inline jet_pair each_root(jet_pair x)
{
    for (int l = 0; l < JET_LANES; l++)
        x[l] = sqrt(x[l]);
    return x;
}

/* ---- e^x ----------------------------------------------------------------- */

/* exp_split, and 2^power: |x| < 700. */
static inline jet_pair each_exp_split(jet_pair x, jet_pair of[2])
{
    const double magic = 0x1.8p52;
    const jet_pair shifted = x * EXP_UNIT + magic, n = shifted - magic;
    const jet_pair r = (x - n * EXP_HIGH) - n * EXP_LOW;
    const jet_pair p = EXP_REST(r);
    const each_bits k = (each_bits) shifted, i = k & (EXP_STEPS - 1);

#define ROOT(l) exp_table[i[l]][0]
#define LESS(l) exp_table[i[l]][1]
    of[0] = JET_EACH(ROOT);
    of[1] = JET_EACH(LESS) + p;
#undef ROOT
#undef LESS
    return (jet_pair) (((k - i) << 47) + ((uint64_t) 1023 << 52));
}

/* |x| < 700. */
static inline jet_pair each_exp(jet_pair x)
{
    jet_pair of[2];
    const jet_pair two = each_exp_split(x, of);

    return (of[0] + of[0] * of[1]) * two;
}

/* (e^x - 1 - x)/x^2 of |x| < 0.35. */
static inline jet_pair each_expm1_rest(jet_pair x)
{
    jet_pair sum = JET_PAIR(EXPM1_LAST);

    for (int n = 0; n < EXPM1_TERMS; n++)
        sum = sum * x + expm1_term[n];
    return sum;
}

/* e^u - 1 and e^u, |u| < 700, as less_one of tape_run.c makes them. */
static inline jet_pair each_less_one(jet_pair u, jet_pair *power)
{
    jet_pair of[2];
    const jet_pair size = each_size(u), two = each_exp_split(u, of);
    const jet_pair scale = two * of[0], e = (of[0] + of[0] * of[1]) * two;
    jet_pair more = (scale - 1.0) + scale * of[1];

    if (each_any(size < 0.35))
        more = jet_choose(
            size < 0.35,
            jet_choose(size < 0x1p-54, u, u + u * u * each_expm1_rest(u)),
            more);
    *power = jet_choose(size > 1.0, e, 1.0 + more);
    return jet_choose(size > 1.0, e - 1.0, more);
}

/* ---- ln x ---------------------------------------------------------------- */

/* ln(x + rest), x normal and finite, |rest| << x. */
static inline jet_pair each_log_sum(jet_pair x, jet_pair rest)
{
    const double magic = 0x1.8p52;
    const each_bits from = (each_bits) x - LN_LOWEST;
    const jet_mask power = (jet_mask) from >> 52;
    const jet_pair part =
        (jet_pair) ((each_bits) x - ((each_bits) power << 52));
    const jet_pair upper = (jet_pair) ((each_bits) part & 0xffffffff00000000);
    const jet_pair k = (jet_pair) (power + (jet_mask) JET_PAIR(magic)) - magic;
    const each_bits i = from >> 46 & (LN_BINS - 1);

#define INVERSE(l) ln_table[i[l]].inverse
#define HIGH(l)    ln_table[i[l]].high
#define LOW(l)     ln_table[i[l]].low
    const jet_pair c = JET_EACH(INVERSE), high = JET_EACH(HIGH),
                   low = JET_EACH(LOW);
#undef INVERSE
#undef HIGH
#undef LOW
    const jet_pair a = upper * c - 1.0, b = (part - upper) * c;
    const jet_pair r = a + b, lost = (a - r) + b;
    const jet_pair first = k * LN2_HIGH + high, sum = first + r;
    const jet_pair series = LN_REST(r);

    return sum +
           ((first - sum) + r + (lost + rest / x + k * LN2_LOW + low) + series);
}

/* ln(1 + x) in the lanes `near`, by what 1 + x is rounded by in those that are
 * also `by_rest`; ln x in others; no number is tiny, none beyond 1e300. */
static inline jet_pair each_ln_of(jet_mask near, jet_mask by_rest, jet_pair x)
{
    const jet_pair sum = jet_choose(near, 1.0 + x, x), one = sum - x;
    const jet_pair rest = (1.0 - one) + (x - (sum - one));
    const jet_pair out =
        each_log_sum(sum, jet_choose(by_rest, rest, JET_PAIR(0.0)));

    return jet_choose(by_rest & (each_size(x) < 0x1p-54), x, out);
}

/* scalar_ln1p(x) in the lanes `near`, ln x in others. */
static inline jet_pair each_ln(jet_mask near, jet_pair x)
{
    return each_ln_of(near, near & (x <= 1.0), x);
}

/* log1p(x), x > -1 */
static inline jet_pair each_log1p(jet_pair x)
{
    return each_ln_of(each_all(), each_all(), x);
}
