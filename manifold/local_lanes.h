/*
 * local_lanes.h -- the series of local.h of a plane, or of n <= JET_MANY of
 * planes that are alike, by registers of 4 or of 8.
 */
#pragma once

#include "local.h"

/* What a series begins with: dep = slope ind, the eigenvalue along it and the
 * other one, in units of exp(log_scale). */
struct local_seed {
    int ind;
    double unit, slope;
    double along, across, log_scale;
};

/* All of out[i] but the radius. */
void local_build_2(const struct planar *const sys[], const struct carry *carry,
                   size_t order, size_t n, const struct local_seed seed[],
                   struct local_series *const out[]);
void local_build_4(const struct planar *const sys[], const struct carry *carry,
                   size_t order, size_t n, const struct local_seed seed[],
                   struct local_series *const out[]);
void local_build_8(const struct planar *const sys[], const struct carry *carry,
                   size_t order, size_t n, const struct local_seed seed[],
                   struct local_series *const out[]);
