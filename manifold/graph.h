/*
 * graph.h -- Taylor series of orbits, each as a graph over one coordinate,
 * expanded side by side (core/jet.h).
 */
#pragma once

#include "local.h"

struct graph_start {
    struct vec2 z; /* offset from the system's origin */
    int ind;       /* its value and lean times the other one's are those of z,
                      and unit s: what the graph is over */
    double lean;
    double unit;
};

/* In powers of s, from 0 to the order. */
struct graph_series {
    double at[2][JET_SIZE]; /* x, y */
    double slope;           /* of the other coordinate by ind, at s = 0 */
    double integral[LOCAL_CARRY_MAX][JET_SIZE]; /* from 0 on */
};

/* S = f_dep/f_ind and the integrals' rates over f_ind, order by order with the
 * graph itself (Jorba & Zou, Exp. Math. 14 (2005) 99-117).  Returns how many of
 * the first ones of `most` > 0, each of its own plane, all alike (many.h), were
 * expanded: 1 or 2 of one plane, or more where planes have jets for many. */
size_t graph_expand(const struct planar *const sys[], const struct carry *carry,
                    size_t order, size_t most, const struct graph_start start[],
                    struct graph_series *const out[]);

/* The s[i] at which the last two terms of u[i] fall to to[i]; infinite where
 * they are zero.  All side by side. */
void graph_reach(size_t order, size_t n, const double *const u[],
                 const double to[], double s[]);

/* A series at s, its derivatives there; the sizes of its last two terms,
 * together, and of those two orders before. */
struct graph_end {
    double value, slope, bend;
    double last, before;
};

/* Of u[i] at s[i], i < n, order > 3, side by side. */
void graph_ends(size_t order, size_t n, const double *const u[],
                const double s[], struct graph_end out[]);

/* What the first and second derivatives by s should be at the end of a step
 * along u, what these are off by, how the rate grows with the unknown itself,
 * times s, and by how much that changes over the step. */
struct graph_rate {
    double value, noise;
    double change, change_noise;
    double growth, bend;
};

/* What a step s along u leaves out: an estimate of it, and a bound on what that
 * is off by. */
struct graph_miss {
    double value, bar;
};

/* By u's derivatives at s against what they should be, d and d' too little.
 * Terms left out, e_1 + e_2 + ..., obey with n the order and g the growth
 *     s d = sum (n + j - g) e_j
 *     s^2 d' = sum (n + j - g) (n + j - 1) e_j
 * where rates grow like g/s, else but for bend e_j.  So
 *     ((2 n + 2 - g) s d - s^2 d')/((n + 1 - g) (n + 2 - g))
 * is their sum but for sum (j - 1) (j - 2) e_j over the same divisor.
 * Where |e_j| <= P r^j, P the last two terms, that is at most 2 (r/(1 - r))^3 P
 * over it: r as the last terms fall, with a margin; and a last term that is off
 * itself, by e_0 of rounding, leaves 2 e_0.  Where they hardly fall, or
 * `smooth` is false, nothing is estimated: the bound is some times the first
 * term as the difference has it, and a part of P, for that may be zero by
 * chance; where it is far more than P, and no rounding, the series knows
 * nothing of a kink: all. */
struct graph_miss graph_missing(const double u[], size_t order, double s,
                                const struct graph_end *end,
                                const struct graph_rate *rate, bool smooth);
