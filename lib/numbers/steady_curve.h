/*
 * steady_curve.h -- steady sliding over the slip rate: friction (Fig 1(a)), and
 * the slope it takes with its stability, the bifurcation diagram (Fig 3).
 * Explicit in v, so nothing is continued: mu = mu_ss(v), alpha = atan mu.
 */
#pragma once

#include "extremum.h"
#include "status.h"

/* A steady state; v is exact, the others belong to it. */
struct steady_point {
    double v; /* dimensionless, as psi */
    struct quantity psi, mu;
    struct quantity slope;                     /* d mu_ss/d ln v */
    struct quantity alpha;                     /* rad; none where mu <= 0 */
    struct quantity lambda_minus, lambda_plus; /* per L/V_star, at alpha */
    int8_t type; /* enum equilibrium_type at that alpha; -1 where there is
                    none */
};

extern const struct record_type record_friction;    /* v, psi, mu, slope */
extern const struct record_type record_bifurcation; /* all but slope */

struct steady_curve {
    struct steady_point *at; /* owned; ascending in v */
    size_t count;
    struct extremum extremum[EXTREMA_MAX]; /* ascending; all there are */
    size_t extrema;
};

/* From v[0] to v[1], as far as there are steady states: evenly in ln v, and
 * at each extremum between them.  STATUS_NO_MEMORY leaves *c empty. */
MUST_CHECK enum status steady_curve_find(const struct law *law,
                                         const struct material *m,
                                         const double v[2],
                                         struct steady_curve *c);

/* A second call is harmless. */
void steady_curve_free(struct steady_curve *c);
