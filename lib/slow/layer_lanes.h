/*
 * layer_lanes.h -- many states at once onto the slow curve (fast_layer.h):
 * each in a lane of its own (lanes.h), with steps of its own; a lane whose
 * state has landed takes the next.
 */
#pragma once

#include <stddef.h>

#include "fast_layer.h"

/* One state: its offset, and how to follow it; peaks are not looked for. */
struct layer_job {
    struct vec2 z;
    struct layer_options options;
};

/* How many lanes at once: 8 or 4 where the processor has them, else 2, or 1; at
 * most `most`. */
int layer_lanes_width(int most);

/* job[n] into out[n], as layer_follow; `width`: as of layer_lanes_width.  Each
 * *out is the same to the bit at any width and whatever the other jobs are. */
void layer_lanes_follow(const struct slow_curve *c, int width,
                        const struct layer_job job[], size_t n,
                        struct layer out[]);

/* The same at one width each; those of 8 and 4 lanes only where the processor
 * has them. */
void layer_lanes_1(const struct slow_curve *c, const struct layer_job job[],
                   size_t n, struct layer out[]);
void layer_lanes_2(const struct slow_curve *c, const struct layer_job job[],
                   size_t n, struct layer out[]);
void layer_lanes_4(const struct slow_curve *c, const struct layer_job job[],
                   size_t n, struct layer out[]);
void layer_lanes_8(const struct slow_curve *c, const struct layer_job job[],
                   size_t n, struct layer out[]);
