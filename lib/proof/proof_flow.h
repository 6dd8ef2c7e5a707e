/*
 * proof_flow.h -- the field along a polynomial, over intervals; polynomials of
 * intervals.
 */
#pragma once

#include "interval_math.h"
#include "interval_tape.h"

/* f_ind, f_dep and what the tape has been asked for beside them - of a block
 * the rate of excess slip, v - v_sp; else 0 -, times one factor. */
struct proof_flow {
    struct interval_series ind, dep, excess;
    double log_scale; /* ln of 1 over that factor */
};

/* Series to order n along ind = at + step t, dep = sum dep[k] t^k, where at and
 * dep[] may be intervals as in interval_tape.h. */
void proof_flow_along(struct interval_tape *t, int ind, struct interval at,
                      double step, const struct interval dep[], size_t n,
                      struct proof_flow *out);

/* Values and derivatives over a box, by ind (coefficient 1 of out[0]) and by
 * dep (out[1]); both have one factor, which values alone choose. */
void proof_flow_slopes(struct interval_tape *t, int ind, struct interval at,
                       struct interval dep, struct proof_flow out[2]);
/* Those by dep only. */
void proof_flow_aside(struct interval_tape *t, int ind, struct interval at,
                      struct interval dep, struct proof_flow *out);

/* Coefficients of p(s + t) in t. */
void proof_shift(size_t n, const struct interval p[], struct interval s,
                 struct interval out[]);
/* p(s), of a polynomial of doubles, and its coefficients as intervals. */
struct interval proof_poly_at(size_t n, const double p[], struct interval s);
/* The same over a box that is not thin: about its middle. */
struct interval proof_poly_over(size_t n, const double p[], struct interval s);
void proof_points(size_t n, const double p[], struct interval out[]);

/* Coefficients of u/w to order n, and of the product u w to order n. */
void proof_quotient(size_t n, const struct interval u[],
                    const struct interval w[], struct interval out[]);

/* sum |u_k| h^k, from k = first to last, rounded up. */
double proof_size(const struct interval u[], size_t first, size_t last,
                  double h);

/* To a double upward: u + w and u w of numbers >= 0. */
double proof_up_sum(long double u, long double w);
double proof_up_times(long double u, long double w);
