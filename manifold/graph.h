/*
 * graph.h -- Taylor series of two orbits, each as a graph over one coordinate,
 * expanded side by side (core/jet.h).
 */
#ifndef MANIFOLD_GRAPH_H
#define MANIFOLD_GRAPH_H

#include "local.h"

struct graph_start {
    struct vec2 z; /* offset from the system's origin */
    int ind;       /* the independent coordinate, ind = its value + unit s */
    double unit;
};

/* In powers of s, from 0 to the order. */
struct graph_series {
    double at[2][JET_SIZE]; /* x, y */
    double slope;           /* of the other coordinate by ind, at s = 0 */
    double integral[LOCAL_CARRY_MAX][JET_SIZE]; /* from 0 on */
};

/* S = f_dep/f_ind and the integrals' rates over f_ind, order by order with the
 * graph itself (Jorba & Zou, Exp. Math. 14 (2005) 99-117). */
void graph_expand(const struct planar *sys, const struct carry *carry,
                  size_t order, const struct graph_start start[2],
                  struct graph_series out[2]);

#endif
