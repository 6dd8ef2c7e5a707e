/*
 * taylor_series.h -- the saddle's stable manifold as the power series that
 * Putelat & Dawes 2015 tried first (section 4.3, to order 14) and found good
 * in a small neighbourhood only:
 *
 *     psi = S(v) = psi_sp + sum_k coefficient_k w^k,   w = (v - v_sp)/v_sp,
 *
 * and how far it converges.  v in units of V_star, psi as the law's (law.h).
 */
#pragma once

#include "jet.h"
#include "record.h"
#include "status.h"

struct study;

enum { TAYLOR_PAPER = 14 /* the order the paper stopped at */ };

struct taylor_term {
    int64_t order;
    struct quantity coefficient; /* of w^order, in psi's unit */
};

struct taylor_series {
    struct taylor_term term[JET_SIZE];
    size_t terms; /* 0: there is no saddle */
    /* Distance from v_sp to the nearest singularity of S in the complex plane,
     * from the last coefficients.  The error is the disagreement of three tests
     * and of the place v_minus where the curve itself ends, which no power
     * series can pass. */
    struct quantity radius;
    /* v up to where the sum of order TAYLOR_PAPER is within TOL_LITTLE
     * of the curve, relative in psi (in e^psi where psi is a logarithm). */
    struct quantity agrees_from, agrees_to;
};
extern const struct record_type record_taylor, record_taylor_term;

/* For a study whose manifold and critical numbers are known.  Without a saddle
 * everything has a reason.  STATUS_NOT_HYPERBOLIC, STATUS_NO_CONVERGENCE as
 * local_at; *out is then untouched. */
MUST_CHECK enum status taylor_series_find(const struct study *s,
                                          struct taylor_series *out);

/* The sum up to `order` < t->terms. */
double taylor_series_at(const struct taylor_series *t, size_t order, double v,
                        double v_sp);
