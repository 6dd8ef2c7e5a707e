/*
 * quasistatic_typed.h -- quasistatic.h for laws of formulas, and what becomes
 * of v there as psi grows, which their formulas are asked for.
 *
 *     mu(v_s(psi), psi) = tan(alpha),      T = int dY/(dY/dt),
 *     X = int v_s dY/(dY/dt)
 *
 * over the chart's Y to infinity: their ends hang on how fast ln(dY/dt) and
 * ln v_s + ln(dY/dt) change with ln Y, and dY/dt on whether psi can follow
 * psi_ss(v) or, if it can go faster than inertia lets v fall, is that.
 */
#ifndef FRICTION_QUASISTATIC_TYPED_H
#define FRICTION_QUASISTATIC_TYPED_H

#include "block.h"

/* As quasistatic_x, quasistatic_above and quasistatic_log_rate; NaN where the
 * formulas have no such value. */
double quasistatic_typed_x(const struct block *b, double Y, double *slope);
double quasistatic_typed_above(const struct block *b, double X, double Y,
                               double excess);
double quasistatic_typed_log_rate(const struct block *b, double X, double Y);

/* At the block's anchor; members of struct block (block.h). */
struct block_end quasistatic_typed_end(const struct block *b);
struct vec2 quasistatic_typed_steep(const struct block *b);
bool quasistatic_typed_is_linear(const struct block *b);
bool quasistatic_typed_traps(const struct block *b);

#endif
