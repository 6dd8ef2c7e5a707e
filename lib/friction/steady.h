/*
 * steady.h -- steady-state friction, its extrema and the anchors on it, in
 * long double: near a fold every digit counts.
 */
#pragma once

#include "law.h"
#include "tape_plane.h"

/* mu_ss(v), x = ln v, and the log form's mu_star + a ln v + b theta_ss(v). */
long double steady_mu(const struct law *law, const struct material *m,
                      long double x);
long double steady_mu_log(const struct law *law, const struct material *m,
                          long double x);

/* What rounding leaves of the latter of a law of formulas, beside what rounds
 * the terms of (2) themselves; 0 of others. */
long double steady_mu_log_off(const struct law *law, const struct material *m,
                              long double x);

/* The chart's y at psi_ss(v); psi_ss(v) itself. */
long double steady_y(const struct law *law, const struct material *m,
                     long double x);
long double steady_psi(const struct law *law, const struct material *m,
                       long double x);

/* ln(1/T(v)), without the -psi_ss of a state that freezes (law_freezes). */
long double steady_log_rate(const struct law *law, const struct material *m,
                            long double x);

/* The mu_log at which mu = tan(alpha): steady states solve
 * steady_mu_log(x) = steady_tau. */
long double steady_tau(const struct law *law, const struct material *m,
                       long double tan_alpha);

/* The abscissae x = ln v of the extrema of mu_ss, ascending, and their number
 * (at most 4).  Closed forms: the roots of a quadratic in v for every
 * composition (for `spinodal` the one of Putelat & Dawes 2015, below (10)). */
size_t steady_extrema(const struct law *law, const struct material *m,
                      long double x[4]);

/* Where psi_ss(v) leaves the law's domain (psi_ss = minus_log under a theta
 * that needs psi > 0): the largest x with a steady state; +infinity if all. */
long double steady_x_max(const struct law *law);

/* A point of the steady-state curve, from which offsets are measured in the
 * chart x = ln v, y = ln psi (y = psi where psi is a logarithm). */
struct anchor {
    double x0, y0;      /* chart coordinates */
    double v0, psi0;    /* slip rate, state = psi_ss(v0) */
    double mu0;         /* mu(v0, psi0) */
    double force0;      /* tan(alpha) - mu0: 0 at an equilibrium */
    double a, b;        /* direct and evolution effect */
    double theta_r;     /* psi0/(c' + psi0): weight of psi in theta */
    double theta_s;     /* c'/(c' + psi0) */
    double log_inertia; /* ln(cos(alpha)/(eps^2 v0)) */
    double log_rate;    /* ln(1/T(v0)), for (45) ln(1/R); less y0 = ln psi0 */
    double w0;          /* asinh form: mu_log/a */
};

/* That at x, where the chart's y is the result.  `equilibrium`: the force
 * balance is zero there by construction, not by subtraction. */
long double steady_anchor(const struct law *law, const struct material *m,
                          long double tan_alpha, long double x,
                          bool equilibrium, struct anchor *at);

/* The field around it; false where a formula has no value there. */
bool steady_plane(const struct law *law, const struct material *m,
                  long double tan_alpha, long double x, bool equilibrium,
                  struct tape_plane *plane);
