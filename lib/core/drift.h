/*
 * drift.h -- how far an orbit (orbit.h) is from the true one: what its
 * polynomials' slopes miss of the field, carried on by the linearised field,
 * signed, so that it fades where orbits close in on each other and cancels
 * where one is late and then early; and what rounding does, carried the same
 * way as a covariance.
 */
#pragma once

#include "rescaled.h"

/* Evaluations of the field and its gradients by drift_carry. */
enum { DRIFT_CALLS = 18 };

/* First order is not enough at a saddle.  An orbit that passes it at q along
 * the unstable direction and is off by e there leaves it late by
 *     |ln(1 - e/q)|/rate <= (e/(rate q)) F(e/q),   F(r) = -ln(1 - r)/r:
 * with r = e/q, which is rate times the lateness to first order, bars are made
 * F(r) times as wide; infinite for r >= 1, for q may be nothing then. */
struct drift {
    double e[CURVE_DIM_MAX]; /* computed less true, to first order, but for */
    double lost[CURVE_DIM_MAX]; /* what rounding made of the ends of steps */
    double rounded;             /* sum of its sizes in the chart */
    double noise[CURVE_DIM_MAX][CURVE_DIM_MAX]; /* covariance */
    double rate, late; /* of the saddle at the origin; r, a bound on it */
    double du[CURVE_DIM_MAX]; /* rates of the true orbit where e is, in some
                                 unit of time */
};

/* At the start, whose coordinates are known to within `rounding`; `rate`: the
 * rate at which orbits leave the saddle at the origin, 0 if there is none. */
void drift_start(struct drift *d, double rounding, double rate);

/* Over the last piece of the curve, of length h on the clock; `missed`: the
 * method's own estimates of what it missed on that piece, for where the field
 * cannot be linearised. */
void drift_carry(struct drift *d, const struct rescaled *clock,
                 const struct curve *c, double h, const double missed[]);

/* e of an integral, i >= 2, since this was last asked: of short steps after
 * long ones a sum of all has no digits. */
double drift_gained(struct drift *d, size_t i);

/* A bound, with what rounding does, on how far component i is off where a
 * function of the chart with this gradient has its value: what is off along the
 * orbit only comes earlier or later. */
double drift_bar(const struct drift *d, struct vec2 gradient, size_t i);

/* The bound where component `which` has its value. */
double drift_bar_at(const struct drift *d, size_t which, size_t i);

/* The bound on how far the orbit is from the true one in the chart, across its
 * way. */
double drift_across(const struct drift *d);
