/*
 * eigen_frame.h -- eigen-coordinates W = (X, Y) of an offset z from a saddle,
 *
 *     z = P W,     columns of P: eigenvectors to lambda_-, lambda_+,
 *
 * (36) of Putelat & Dawes (2015), whose X and Y are these over B.
 */
#pragma once

#include "equilibrium.h"

/* P.  Each column has its larger component 1 in size and x > 0 (y > 0 where
 * x = 0): x-component 1 where the eigenvector is flatter than the diagonal. */
struct mat2 eigen_basis(const struct equilibrium *e);

/* P W, and P^-1 z: not finite where the eigenvectors coincide. */
struct vec2 eigen_point(struct mat2 basis, struct vec2 W);
struct vec2 eigen_coordinates(struct mat2 basis, struct vec2 z);
