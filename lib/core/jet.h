/*
 * jet.h -- truncated Taylor series, one coefficient at a time.
 *
 * A series is an array of JET_SIZE doubles, u(s) = sum u[k] s^k.  Each
 * operation below computes coefficient k of its result from coefficients 0..k
 * of its arguments and 0..k-1 of itself and of its helper series: calling it
 * for k = 0, 1, 2, ... builds the whole series at the cost of one convolution
 * an operation (Moore 1966; Jorba & Zou, Exp. Math. 14 (2005) 99-117, sec. 3).
 * Order 0 is evaluated by the same careful scalar code as everywhere else.
 */
#ifndef CORE_JET_H
#define CORE_JET_H

#include <stddef.h>
#include <string.h>

enum {
    JET_SIZE = 32,  /* coefficients 0..31 */
    JET_SLOTS = 48, /* intermediate series of one field and its observables */
};

/* The intermediate series of a field along one curve.  Slots are handed out
 * in call order, so the same sequence of calls finds the same series again. */
struct jet_work {
    const double *linear; /* series known to end after s^1; NULL if none */
    double log_scale;     /* set by the field at k = 0 */
    double frozen[4];     /* whatever else the field fixes at k = 0 */
    size_t used;
    double slot[JET_SLOTS][JET_SIZE];
};

/* The next free series; forget them all with w->used = 0. */
static inline double *jet_slot(struct jet_work *w)
{
    return w->slot[w->used++];
}

/* 0, 1, 2, ... and 0, 1, 1/2, 1/3, ... */
extern const double jet_number[JET_SIZE], jet_inverse[JET_SIZE];

/* Sums run in lanes whose order is fixed here, not by the compiler, so that
 * the same numbers come out of every instruction set; the newest coefficients
 * come last, so that a processor can work ahead of them. */
typedef double jet_pair __attribute__((vector_size(16)));

static inline jet_pair jet_load(const double *p)
{
    jet_pair q;
    memcpy(&q, p, sizeof q);
    return q;
}

/* {p[0], p[-1]} */
static inline jet_pair jet_load_back(const double *p)
{
    const jet_pair q = jet_load(p - 1);
    return (jet_pair){ q[1], q[0] };
}

/* sum_{j=1}^{k-1} u[j] v[k-j] */
static inline double jet_inner(size_t k, const double u[], const double v[])
{
    jet_pair low = { 0 }, high = { 0 };
    double rest = 0.0;
    size_t j = 1;

    for (; j + 4 <= k; j += 4) {
        low += jet_load(u + j) * jet_load_back(v + k - j);
        high += jet_load(u + j + 2) * jet_load_back(v + k - j - 2);
    }
    for (; j < k; j++)
        rest += u[j] * v[k - j];
    low += high;
    return low[0] + low[1] + rest;
}

/* sum_{j=0}^{k} u[j] v[k-j] */
static inline double jet_product(size_t k, const double u[], const double v[])
{
    if (k == 0)
        return u[0] * v[0];
    return jet_inner(k, u, v) + (u[0] * v[k] + u[k] * v[0]);
}

/* sum_{j=0}^{k} u[j] u[k-j] */
static inline double jet_square(size_t k, const double u[])
{
    double sum = 0.0;

    for (size_t j = 1; 2 * j < k; j++)
        sum += u[j] * u[k - j];
    sum += k == 0 ? 0.0 : u[0] * u[k];
    return 2.0 * sum + (k % 2 == 0 ? u[k / 2] * u[k / 2] : 0.0);
}

/* sum_{j=1}^{k} j u[j] v[k-j]: k times coefficient k of the integral of u' v;
 * one term where u is w->linear. */
static inline double jet_chain(const struct jet_work *w, size_t k,
                               const double u[], const double v[])
{
    jet_pair low = { 0 }, high = { 0 };
    double rest = 0.0;
    size_t j = 1;

    if (u == w->linear)
        return u[1] * v[k - 1];
    for (; j + 4 <= k; j += 4) {
        low += jet_load(jet_number + j) * jet_load(u + j) *
               jet_load_back(v + k - j);
        high += jet_load(jet_number + j + 2) * jet_load(u + j + 2) *
                jet_load_back(v + k - j - 2);
    }
    for (; j < k; j++)
        rest += jet_number[j] * u[j] * v[k - j];
    low += high;
    return low[0] + low[1] + rest + jet_number[k] * u[k] * v[0];
}

/* Coefficient k of num / den, den[0] != 0, given quotient[0..k-1]. */
static inline double jet_quotient(size_t k, const double num[],
                                  const double den[], const double quotient[])
{
    if (k == 0)
        return num[0] / den[0];
    return (num[k] - jet_inner(k, quotient, den) - quotient[0] * den[k]) /
           den[0];
}

/* sum_{k=0}^{order} u[k] s^k, and its derivative. */
double jet_at(size_t order, const double u[], double s);
double jet_slope_at(size_t order, const double u[], double s);

#endif
