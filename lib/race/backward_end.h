/*
 * backward_end.h -- where a curve may stop being followed because what is left
 * of it is negligible: a limit of one coordinate while the other one grows.
 */
#pragma once

#include "local.h"

/* A saddle at sys->origin and what is integrated along its manifold. */
struct backward_way {
    const struct planar *sys;        /* borrowed */
    const struct carry *carry;       /* borrowed */
    bool converges[LOCAL_CARRY_MAX]; /* the rate vanishes at the saddle */
};

struct backward_way backward_way_of(const struct planar *sys,
                                    const struct carry *carry);

/* The rate of carried quantity i at z over exp(log_scale). */
double backward_rate(const struct backward_way *g, size_t i, struct vec2 z,
                     double log_scale);

/* How the curve runs at a point: the coordinate that moves faster, and how
 * fast the other one and the integrals follow. */
struct backward_heading {
    int ind;
    double at;    /* coordinate ind */
    double dep;   /* the other one */
    double slope; /* d dep/d ind */
    double swift[LOCAL_CARRY_MAX];
};

/* At the offset z, if `ind` (-1: the faster one) is taken to run. */
struct backward_heading backward_heading_at(const struct backward_way *g,
                                            int ind, struct vec2 z);

/* What is left beyond the point `now`. */
struct backward_rest {
    double dep;
    double total[LOCAL_CARRY_MAX]; /* 0 where an integral does not converge */
};

/* Whether everything left is below `part` of dep and of total[]: exponentials
 * through the headings at two points, earlier and now; and no more than their
 * like anywhere along the asymptote, up to the edge of the domain. */
bool backward_end_near(const struct backward_way *g,
                       const struct backward_heading *earlier,
                       const struct backward_heading *now, const double total[],
                       double part, struct backward_rest *rest);
