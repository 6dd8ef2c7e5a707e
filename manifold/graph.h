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

/* What the derivative by s should be at the end of a step, its rounding, and
 * how a rate grows with the unknown itself, times s. */
struct graph_rate {
    double value, noise, growth;
};

/* What a step s along u leaves out: an estimate of it, and a bound on what that
 * is off by. */
struct graph_miss {
    double value, bar;
};

/* By u's derivative at s against rate, what it should be.  Terms left out, e_1
 * + e_2 + ..., have the derivative sum (order + j)/s e_j, of which growth/s e_j
 * is missing if u itself makes the rate; so the difference, times s over order
 * + 1 - growth, is their sum but for sum (j - 1) e_j/(order + 1 - growth).
 * Where |e_j| <= P r^j, P the last two terms, that is at most (r/(1 - r))^2 P
 * over the same: r as the last terms fall, with a margin.  Where they hardly
 * fall, or `smooth` is false, nothing is estimated: the bound is some times the
 * first term as the difference has it, and a part of P, for that may be zero by
 * chance; where it is far more than P, and no rounding, the series knows
 * nothing of a kink: all. */
struct graph_miss graph_missing(const double u[], size_t order, double s,
                                const struct graph_rate *rate, bool smooth);

#endif
