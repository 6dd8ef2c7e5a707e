/*
 * landing_halves.h -- what a step of a landing (landing.h) misses, by how its
 * end differs from that of two of half its length.
 */
#pragma once

#include "landing.h"

/* Across the orbit where the step ends, to its left, and of time and slip where
 * it has come as far along. */
struct landing_halves {
    double across, time, slip;
};

/* Of the step of length h from `from`. */
struct landing_halves landing_halve(const struct slider *s, struct vec2 from,
                                    double h);

/* d(x, y, t, slip)/ds, s the arc length; ctx: the slider. */
void landing_along(const void *ctx, double s, const double u[], double du[]);
