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

/* The s at which the last two terms of u fall to tol * scale; infinite where
 * they are zero. */
double graph_reach(const double u[], size_t order, double scale, double tol);

/* What a step s along u may have cost, by u's derivative there against `rate`,
 * what it should be: the first term left out is s/(order + 1) times what it is
 * off; where that is zero by chance, a part of the last terms; where it is far
 * more than these, and no rounding, the series knows nothing of a kink: all. */
double graph_truncation(const double u[], size_t order, double s, double rate);

#endif
