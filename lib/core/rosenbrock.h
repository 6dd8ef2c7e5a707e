/*
 * rosenbrock.h -- one step of Rodas5P, an L-stable, stiffly accurate
 * Rosenbrock method of order 5 with error estimate and dense output of order
 * 4: Steinebach, BIT Numer. Math. 63 (2023) 27.
 */
#ifndef CORE_ROSENBROCK_H
#define CORE_ROSENBROCK_H

#include "curve.h"
#include "plane.h"

enum { ROSENBROCK_STAGES = 8, ROSENBROCK_DEGREE = 4, ROSENBROCK_CALLS = 7 };

/* u' = rhs(z), z = (u_0, u_1): an autonomous system in which the components
 * from 2 on are integrals that do not feed back. */
struct cascade {
    size_t dim; /* <= CURVE_DIM_MAX */
    void (*rhs)(const void *ctx, struct vec2 z, double du[]);
    const void *ctx; /* borrowed */
};

/* rhs with its gradients at the start of the step: `slope[i]` = gradient of
 * du[i] in z, rows 0 and 1 being the Jacobian of z. */
struct cascade_linear {
    double du[CURVE_DIM_MAX];
    struct vec2 slope[CURVE_DIM_MAX];
};

/* The stage increments: u1 = u + sums of them, the last one is the error. */
struct rosenbrock {
    double k[ROSENBROCK_STAGES][CURVE_DIM_MAX];
};

/* From u to u1, one step of size h (of either sign) later; error = k[7], the
 * difference to the embedded method of order 4.  Nothing fails: results that
 * are not finite say that the step was too long. */
void rosenbrock_try(struct rosenbrock *w, const struct cascade *system,
                    const struct cascade_linear *at, const double u[], double h,
                    double u1[]);

/* After rosenbrock_try: the polynomial in theta, theta = 0 at u and 1 at u1,
 * as coef[i * (ROSENBROCK_DEGREE + 1) + j]. */
void rosenbrock_dense(const struct rosenbrock *w, size_t dim, const double u[],
                      const double u1[], double coef[]);

#endif
