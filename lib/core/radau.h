/*
 * radau.h -- one step of the Radau IIA method with five stages: order 9,
 * L-stable, stiffly accurate, with error estimate and dense output of order 5.
 * Hairer & Wanner, Solving ODEs II (1996), sec. IV.5, IV.8; J. Comput. Appl.
 * Math. 111 (1999) 93-111.
 */
#pragma once

#include <stdbool.h>

#include "curve.h"
#include "plane.h"

enum { RADAU_STAGES = 5, RADAU_DEGREE = 5 };

/* u' = rhs(z), z = (u_0, u_1): an autonomous system in which the components
 * from 2 on are integrals that do not feed back. */
struct cascade {
    size_t dim; /* <= CURVE_DIM_MAX */
    /* Writes du[0], du[1]. */
    void (*plane)(const void *ctx, struct vec2 z, double du[]);
    /* Called after plane with the same z and du: writes all the others. */
    void (*integrals)(const void *ctx, struct vec2 z, double du[]);
    const void *ctx; /* borrowed */
};

/* rhs at the start of a step, and gradients: `slope[i]` = that of du[i] in z,
 * rows 0 and 1 being the Jacobian of z.  Gradients from anywhere on the step
 * do; those at RADAU_MIDDLE converge best (measured). */
struct cascade_linear {
    double du[CURVE_DIM_MAX];
    struct vec2 slope[CURVE_DIM_MAX];
};

enum { RADAU_MIDDLE = 3 }; /* the stage at 0.86 of the step */

/* A step being made. */
struct radau {
    struct vec2 z[RADAU_STAGES]; /* stages, less the step's start; the last
                                    one is the step's end */
    double du[RADAU_STAGES][CURVE_DIM_MAX]; /* rhs there */
    /* What an iteration leaves of the error, as last measured; 1: unknown.
     * Carried from step to step by the caller. */
    double rate;
    size_t iterations; /* of RADAU_STAGES calls each */
};

/* First guess of z: a straight line with slope du. */
void radau_start(struct radau *w, const double du[], double h);

/* First guess of z: the last step's polynomials, as radau_finish left them,
 * continued to a step `ratio` times as long. */
void radau_extend(struct radau *w, const double coef[], double ratio);

/* From the guess to the solution of the step of size h (of either sign) from
 * u, to about `tol` in z (absolute; not below rounding).  False: no
 * convergence, or something is not finite; the step was too long. */
bool radau_solve(struct radau *w, const struct cascade *system,
                 const struct cascade_linear *at, const double u[], double h,
                 double tol);

/* After radau_solve: the polynomial in theta, theta = 0 at u and 1 at the end
 * of the step, as coef[i * (RADAU_DEGREE + 1) + j]; and its error, estimated
 * anywhere on the step: that of an embedded method of order 5, also where
 * something decays fast.  One more call of `plane`. */
void radau_finish(const struct radau *w, const struct cascade *system,
                  const struct cascade_linear *at, const double u[], double h,
                  double coef[], double error[]);
