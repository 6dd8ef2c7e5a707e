/*
 * graph_kernels.h -- graph_reach and graph_ends of n <= 2 series, or of n <=
 * JET_MANY by registers of 4 or of 8.
 */
#pragma once

#include "graph.h"

struct graph_kernels {
    void (*reach)(size_t order, size_t n, const double *const u[],
                  const double to[], double s[]);
    void (*ends)(size_t order, size_t n, const double *const u[],
                 const double s[], struct graph_end out[]);
};

extern const struct graph_kernels graph_kernels_2, graph_kernels_4,
    graph_kernels_8;
