/*
 * steady.h -- steady-state friction, its extrema and the anchors on it, in
 * long double: near a fold every digit counts.
 */
#ifndef FRICTION_STEADY_H
#define FRICTION_STEADY_H

#include "anchor.h"
#include "tape_plane.h"

/* mu_ss(v), x = ln v, and the log form's mu_star + a ln v + b theta_ss(v). */
long double steady_mu(const struct law *law, const struct material *m,
                      long double x);
long double steady_mu_log(const struct law *law, const struct material *m,
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

/* Everything about the point x of the steady-state curve that the field is
 * computed from (anchor.h).  `equilibrium`: the force balance is zero there by
 * construction, not by subtraction. */
void steady_anchor(const struct law *law, const struct material *m,
                   long double tan_alpha, long double x, bool equilibrium,
                   struct anchor *at);

/* The field around it; false where a formula has no value there. */
bool steady_plane(const struct law *law, const struct material *m,
                  long double tan_alpha, long double x, bool equilibrium,
                  struct tape_plane *plane);

#endif
