/*
 * quasistatic.h -- the block that inertia no longer moves: friction balances
 * the slope, mu(v, psi) = tan(alpha), which is (17) at eps = 0, and v follows
 * from psi alone:
 *
 *     ln v = (tau - mu_star - b theta(psi))/a,
 *
 * with tau as of steady_tau.  Offsets X, Y from the block's anchor as in
 * steady.h, but of any size: rates are logarithms, and what e^X underflows to
 * is its limit.
 */
#pragma once

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

/* ---- laws of formulas ----------------------------------------------------
 *
 * What becomes of v there as psi grows is asked of the formulas:
 *
 *     mu(v_s(psi), psi) = tan(alpha),      T = int dY/(dY/dt),
 *     X = int v_s dY/(dY/dt)
 *
 * over the chart's Y to infinity: their ends hang on how fast ln(dY/dt) and
 * ln v_s + ln(dY/dt) change with ln Y, and dY/dt on whether psi can follow
 * psi_ss(v) or, if it can go faster than inertia lets v fall, is that. */

/* As quasistatic_x and quasistatic_above; NaN where the formulas have no such
 * value. */
double quasistatic_typed_x(const struct block *b, double Y, double *slope);
double quasistatic_typed_above(const struct block *b, double X, double Y,
                               double excess);

/* At the block's anchor; members of struct block (block.h). */
struct block_end quasistatic_typed_end(const struct block *b);
struct vec2 quasistatic_typed_steep(const struct block *b);
bool quasistatic_typed_is_linear(const struct block *b);
bool quasistatic_typed_traps(const struct block *b);
