/*
 * quasistatic.h -- the block that inertia no longer moves: friction balances
 * the slope, mu(v, psi) = tan(alpha), which is (17) at eps = 0, and v follows
 * from psi alone:
 *
 *     ln v = (tau - mu_star - b theta(psi))/a,
 *
 * with tau as of steady_tau.  Offsets X, Y from the block's anchor as in
 * anchor.h, but of any size: rates are logarithms, and what e^X underflows to
 * is its limit.
 */
#ifndef FRICTION_QUASISTATIC_H
#define FRICTION_QUASISTATIC_H

#include "block.h"

/* X where mu = tan(alpha), and dX/dY < 0. */
double quasistatic_x(const struct block *b, double Y, double *slope);

/* How far above it, from X on, mu - tan(alpha) is `excess`, >= 0. */
double quasistatic_above(const struct block *b, double X, double Y,
                         double excess);

/* ln(dY/dt), per L/V_star, of a state that grows below psi_ss(v); NaN where it
 * does not.  For laws by which a block comes to rest, not of those with K =
 * sinh and psi_ss = 1/v, unless they freeze. */
double quasistatic_log_rate(const struct block *b, double X, double Y);

#endif
