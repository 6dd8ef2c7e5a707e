/*
 * curve.h -- a piecewise polynomial curve in R^dim: what every integration in
 * Slipway returns, so that one piece of code draws, cuts and stores them all.
 *
 * On piece p, with theta in [0, 1],
 *     value_i = sum_j coef[i * (degree + 1) + j] theta^j.
 * Components 0 and 1 are the offsets (x, y) from the system's origin, the
 * others the integrals of observables.  The curve is continuous up to the
 * error of the method that made it.
 */
#pragma once

#include <stddef.h>

#include "plane.h"
#include "status.h"

enum { CURVE_DIM_MAX = 10 };

/* One polynomial of each component, in theta = 0..1 along the piece. */
struct curve_piece {
    size_t degree;
    size_t first;  /* index into curve.coef of component 0, coefficient 0 */
    double error;  /* bound on the error of (x, y) at its end, as far as the
                      curve's maker knows; 0 where it does not say */
    double across; /* the same of how far any of it is beside the true curve */
};

/* Pieces one after another, and the coefficients of all of them. */
struct curve {
    size_t dim;
    struct curve_piece *piece; /* owned */
    size_t count, piece_room;
    double *coef; /* owned */
    size_t coefs, coef_room;
};

/* Without pieces; may be freed. */
#define CURVE_EMPTY(dim_) ((struct curve){ .dim = (dim_) })

/* Appends a piece and points *coef at its dim * (degree + 1) coefficients,
 * to be filled by the caller before the next call.  On STATUS_NO_MEMORY the
 * curve is unchanged. */
MUST_CHECK enum status curve_push(struct curve *c, size_t degree,
                                  double **coef);

/* All components at theta on a piece: out[0 .. dim-1]. */
void curve_at(const struct curve *c, size_t piece, double theta, double out[]);

/* The first two of them. */
struct vec2 curve_point(const struct curve *c, size_t piece, double theta);

/* d/dtheta of all components. */
void curve_slope_at(const struct curve *c, size_t piece, double theta,
                    double out[]);

/* One component's polynomial on a piece: degree + 1 coefficients, borrowed. */
const double *curve_component(const struct curve *c, size_t piece, size_t i);

/* Leaves *c empty with the same dim, so a second call is harmless. */
void curve_free(struct curve *c);
