/*
 * quad_radau.h -- one step of the Radau IIA method with QUAD_STAGES stages in
 * 113 bits: order 2 QUAD_STAGES - 1, L-stable, stiffly accurate.
 */
#pragma once

#include <stdbool.h>

#include "plane.h"
#include "quad.h"

enum { QUAD_STAGES = 11, QUAD_MOST = 5 };

/* The method, in shifted Legendre polynomials P_k. */
struct quad_method {
    quad node[QUAD_STAGES]; /* of the stages; the last one is 1 */
    quad a[QUAD_STAGES][QUAD_STAGES];
    quad moment[QUAD_STAGES][QUAD_STAGES]; /* [k][j]: of rate j in P_k */
};

void quad_method_init(struct quad_method *m);

/* u' = rhs(u_0, u_1): two components that feed back, time, and integrals over
 * time. */
struct quad_system {
    const struct quad_method *method; /* borrowed */
    void (*plane)(const void *ctx, const quad z[2], quad du[]);
    /* The others, in proportion to du[2]; after plane with the same z. */
    void (*integrals)(const void *ctx, const quad z[2], quad du[]);
    /* The same plane in double precision with its gradients: what steps are
     * solved with, which the 113-bit residual then judges. */
    void (*linear)(const void *ctx, const quad z[2], double du[2],
                   struct vec2 slope[2]);
    const void *ctx; /* borrowed */
};

/* A step being made, or made: its end is u + z[QUAD_STAGES - 1]. */
struct quad_radau {
    quad h;
    quad bend; /* rates are those of the system times e^(bend tau), tau from the
                  step's start: a clock that runs with the orbit */
    quad z[QUAD_STAGES][2];            /* stages, less the step's start */
    quad du[QUAD_STAGES][QUAD_MOST];   /* rates there */
    quad rate[QUAD_MOST][QUAD_STAGES]; /* once solved: [k][i], of P_i in the
                                          rate of component k */
};

/* From the guess w->z to the solution of the step w->h from u[2], to `tol` in
 * z (absolute).  False: no convergence; the step was too long. */
bool quad_radau_solve(struct quad_radau *w, const struct quad_system *system,
                      const quad u[], double tol);

/* What component k has gained at the part theta of a step that was solved,
 * beyond theta = 1 too; for all but theta = 1 of order QUAD_STAGES + 1. */
quad quad_radau_gain(const struct quad_radau *w, int k, quad theta);

/* The size of the last coefficients of component k's polynomial. */
quad quad_radau_tail(const struct quad_radau *w, int k);
