/* picture_taylor.h -- the power series of the stable manifold in a portrait. */
#pragma once

#include "figure.h"
#include "study.h"

/* Adds sums of several orders, over the whole window, and a band over where
 * the series converges; nothing where the study has no such series.
 * shown(ctx, (v, psi)) is the point on the axes. */
void picture_add_taylor(const struct study *s,
                        struct vec2 (*shown)(const void *ctx, struct vec2),
                        const void *ctx, struct figure *f);
