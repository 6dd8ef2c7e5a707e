/*
 * jet.h -- truncated Taylor series, one coefficient at a time, of two curves
 * side by side: a processor does both at the price of one.
 *
 * A series is an array of JET_SIZE pairs, u(s) = sum u[k] s^k, lane by lane;
 * lanes never touch each other.  What is compiled for JET_MANY lanes has
 * "pairs" of so many (planar.h), with the same bits in each.  Each operation
 * below computes coefficient k of its result from coefficients 0..k of its
 * arguments and 0..k-1 of itself and of its helper series: calling it for k =
 * 0, 1, 2, ... builds the whole series at the cost of one convolution an
 * operation (Moore 1966; Jorba & Zou, Exp. Math. 14 (2005) 99-117, sec. 3).
 * Order 0 is evaluated by the same careful scalar code as everywhere else, or
 * over lanes with its bits (elementary_lanes.h).
 */
#pragma once

#include <stddef.h>

#ifndef JET_LANES
#define JET_LANES 2
#endif

enum {
    JET_SIZE = 32,   /* coefficients 0..31 */
    JET_SLOTS = 304, /* intermediate series of one field and its observables */
    JET_MANY = 8
};

/* Coefficient k of both curves; [0] and [1] are doubles. */
typedef double jet_pair __attribute__((vector_size(8 * JET_LANES)));

/* The same number in both lanes; a pair stays what it is. */
#define JET_PAIR(p) ((jet_pair){ 0 } + (p))

/* f(0), f(1), ... in their lanes. */
#if JET_LANES == 2
#define JET_EACH(f) ((jet_pair){ f(0), f(1) })
#else
#define JET_EACH(f)                                                            \
    ((jet_pair){ f(0), f(1), f(2), f(3), f(4), f(5), f(6), f(7) })
#endif

/* Lanes of all bits or of none. */
typedef __typeof__((jet_pair){ 0 } == (jet_pair){ 0 }) jet_mask;

/* u in lanes of the mask, v in the others; as bits, for a lane that is written
 * by itself stalls whoever reads the pair soon after. */
static inline jet_pair jet_choose(jet_mask mask, jet_pair u, jet_pair v)
{
    return (jet_pair) ((mask & (jet_mask) u) | (~mask & (jet_mask) v));
}

/* The intermediate series of a field along the curves.  Slots are handed out
 * in call order, so the same sequence of calls finds the same series again. */
struct jet_work {
    const jet_pair *linear; /* series known to end after s^1 in both lanes;
                               NULL if none */
    int lanes;              /* of JET_MANY: those beyond are as the first */
    jet_pair log_scale;     /* set by the field at k = 0 */
    size_t used;            /* slots; for systems that hand them out */
    _Alignas(64) jet_pair slot[JET_SLOTS][JET_SIZE]; /* as a cache's lines */
};

/* How many doubles a register of this processor holds: 2, 4 or 8. */
int jet_width(void);

/* 0, 1, 2, ... and 0, 1, 1/2, 1/3, ... */
extern const double jet_number[JET_SIZE], jet_inverse[JET_SIZE];

/* sum_{j=0}^{n-1} u[j] v[-j], n < JET_SIZE, in two parts that do not wait for
 * each other; entered in the middle, for a loop costs as much as its sum. */
static inline jet_pair jet_sum(size_t n, const jet_pair *u, const jet_pair *v)
{
    jet_pair part[2] = { { 0 }, { 0 } };

#define JET_TERM(j)                                                            \
    case (j) + 1:                                                              \
        part[(j) % 2] += u[j] * v[-(j)];                                       \
        __attribute__((fallthrough))
#define JET_TERMS(j)                                                           \
    JET_TERM(j + 3);                                                           \
    JET_TERM(j + 2);                                                           \
    JET_TERM(j + 1);                                                           \
    JET_TERM(j)
    switch (n) {
        JET_TERM(30);
        JET_TERM(29);
        JET_TERM(28);
        JET_TERMS(24);
        JET_TERMS(20);
        JET_TERMS(16);
        JET_TERMS(12);
        JET_TERMS(8);
        JET_TERMS(4);
        JET_TERMS(0);
        default:
            break;
    }
#undef JET_TERMS
#undef JET_TERM
    return part[0] + part[1];
}

/* Coefficient k of num / den, den[0] != 0, given quotient[0..k-1]. */
static inline jet_pair jet_quotient(size_t k, const jet_pair num[],
                                    const jet_pair den[],
                                    const jet_pair quotient[])
{
    if (k == 0)
        return num[0] / den[0];
    const jet_pair known = jet_sum(k - 1, quotient + 1, den + k - 1);
    return (num[k] - quotient[0] * den[k] - known) / den[0];
}

/* The series of one curve, taken out of a lane. */
static inline void jet_take(size_t order, const jet_pair u[], size_t lane,
                            double out[])
{
    for (size_t k = 0; k <= order; k++)
        out[k] = u[k][lane];
}

/* Of one curve: sum_{k=0}^{order} u[k] s^k, and its derivative. */
double jet_at(size_t order, const double u[], double s);
double jet_slope_at(size_t order, const double u[], double s);

/* sum |c_k| h^k over k > 0, h >= 0, c_k the coefficients about s: for |t| <= h
 * the series at s + t is no further from that at s, but for rounding, less than
 * 2 (order + 1) DBL_EPSILON sum |u[k]| (|s| + h)^k. */
double jet_spread_at(size_t order, const double u[], double s, double h);
