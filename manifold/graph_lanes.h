/*
 * graph_lanes.h -- graph_expand of n <= 2 graphs of a plane, or of n <=
 * JET_MANY of planes that are alike, by registers of 4 or of 8.
 */
#pragma once

#include "graph.h"

void graph_expand_2(const struct planar *const sys[], const struct carry *carry,
                    size_t order, size_t n, const struct graph_start start[],
                    struct graph_series *const out[]);
void graph_expand_4(const struct planar *const sys[], const struct carry *carry,
                    size_t order, size_t n, const struct graph_start start[],
                    struct graph_series *const out[]);
void graph_expand_8(const struct planar *const sys[], const struct carry *carry,
                    size_t order, size_t n, const struct graph_start start[],
                    struct graph_series *const out[]);
