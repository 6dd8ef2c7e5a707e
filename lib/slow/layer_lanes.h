/*
 * layer_lanes.h -- layer_follow (fast_layer.h) at one width each; those of 8
 * and 4 lanes only where the processor has them.
 */
#pragma once

#include "fast_layer.h"

void layer_lanes_1(const struct slow_curve *c, const struct layer_job job[],
                   size_t n, struct layer out[]);
void layer_lanes_2(const struct slow_curve *c, const struct layer_job job[],
                   size_t n, struct layer out[]);
void layer_lanes_4(const struct slow_curve *c, const struct layer_job job[],
                   size_t n, struct layer out[]);
void layer_lanes_8(const struct slow_curve *c, const struct layer_job job[],
                   size_t n, struct layer out[]);
