/*
 * eigen_frame.h -- eigen-coordinates W = (X, Y) of an offset z from a saddle,
 *
 *     z = P W,     columns of P: eigenvectors to lambda_-, lambda_+,
 *
 * (36) of Putelat & Dawes (2015), whose X and Y are these over B; and a planar
 * system seen in them.
 */
#ifndef MANIFOLD_EIGEN_FRAME_H
#define MANIFOLD_EIGEN_FRAME_H

#include "local.h"

/* P.  Each column has its larger component 1 in size and x > 0 (y > 0 where
 * x = 0): x-component 1 where the eigenvector is flatter than the diagonal. */
struct mat2 eigen_basis(const struct equilibrium *e);

/* P W, and P^-1 z: not finite where the eigenvectors coincide. */
struct vec2 eigen_point(struct mat2 basis, struct vec2 W);
struct vec2 eigen_coordinates(struct mat2 basis, struct vec2 z);

/* A saddle at sys->origin and what is integrated along its manifold. */
struct eigen_frame {
    const struct planar *sys;  /* borrowed */
    const struct carry *carry; /* borrowed */
    struct mat2 basis;
    double ratio; /* lambda_+ / lambda_- */
    double thin;  /* x is this part of X at first, and of the order of Y later:
                     what is added to Y below this part of X is lost on x */
    bool converges[LOCAL_CARRY_MAX]; /* the rate vanishes at the saddle */
};

struct eigen_frame eigen_frame_at(const struct planar *sys,
                                  const struct equilibrium *e,
                                  const struct carry *carry);

/* dW/dt over exp(*log_scale). */
struct vec2 eigen_velocity(const struct eigen_frame *g, struct vec2 W,
                           double *log_scale);

/* The rate of carried quantity i at z over exp(log_scale). */
double eigen_rate(const struct eigen_frame *g, size_t i, struct vec2 z,
                  double log_scale);

/* Its gradient; and what a rounding of z makes of it, likewise. */
struct vec2 eigen_rate_gradient(const struct eigen_frame *g, size_t i,
                                struct vec2 z, double log_scale);
double eigen_rate_noise(const struct eigen_frame *g, size_t i, struct vec2 z,
                        double log_scale);

#endif
