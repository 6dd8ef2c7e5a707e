/*
 * eigen_start.h -- a stable manifold Y = S(X) from its saddle to where steps
 * can begin: S = c2 X^2 + c3 X^3, by collocation of (37), S' = Ydot/Xdot, the
 * distance shortened until the field agrees between the points as well.
 */
#ifndef RACE_EIGEN_START_H
#define RACE_EIGEN_START_H

#include "eigen_frame.h"

enum { EIGEN_START_DEGREE = 3 };

/* Polynomials in part = X/reach on [0, 1]. */
struct eigen_start {
    double reach; /* X at its end, signed */
    double Y[EIGEN_START_DEGREE + 1];
    double integral[LOCAL_CARRY_MAX][EIGEN_START_DEGREE + 1];
};

/* W at part of the way. */
struct vec2 eigen_start_point(const struct eigen_start *t, double part);

/* A start that meets the tolerance tol, relative, on the side of the sign of
 * `guess`, no further out than that.  STATUS_NO_CONVERGENCE: none is near
 * enough. */
MUST_CHECK enum status eigen_start_find(const struct eigen_frame *g, double tol,
                                        double guess, struct eigen_start *t);

#endif
