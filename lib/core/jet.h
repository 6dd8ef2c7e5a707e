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

/* sum_{j=0}^{k} u[j] v[k-j] */
double jet_product(size_t k, const double u[], const double v[]);

/* sum_{j=1}^{k} j u[j] v[k-j]: k times coefficient k of the integral of u' v;
 * one term where u is w->linear. */
double jet_chain(const struct jet_work *w, size_t k, const double u[],
                 const double v[]);

/* Coefficient k of num / den, den[0] != 0, given quotient[0..k-1]. */
double jet_quotient(size_t k, const double num[], const double den[],
                    const double quotient[]);

/* sum_{k=0}^{order} u[k] s^k, and its derivative. */
double jet_at(size_t order, const double u[], double s);
double jet_slope_at(size_t order, const double u[], double s);

#endif
