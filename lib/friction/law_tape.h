/*
 * law_tape.h -- a block on a slope, (17), from the formulas of its law as
 * people type them, lowered to differences from a steady state (tape.h).
 */
#pragma once

#include "law.h"
#include "tape_plane.h"

/* ---- the names that formulas may have ------------------------------------ */

enum { LAW_VALUES = 27 };

/* Where the steady curve is left from, ln v and the chart's y; no formula of a
 * user's can have these. */
#define LAW_LNV0 "ln v0"
#define LAW_Y0   "y of v0"

/* R = inf: as good as that beside any v >= 1e-300, and not too large for 113
 * bits. */
#define LAW_R_INFINITE 1e4000L

/* A new graph of them. */
void law_names(const struct law *law, struct formula *f);

/* Ended by none; at x = ln v and the chart's y. */
void law_values(const struct law *law, const struct material *m,
                formula_real tan_alpha, formula_real x, formula_real y,
                struct formula_value out[LAW_VALUES]);

/* ---- tapes --------------------------------------------------------------- */

/* Rates of the chart (ln v, ln psi) or (ln v, psi) per t*; value 0 is mu.
 * out->f must know the constants tan_alpha, mu_star, a, b, c, R, V_c, eps2,
 * LAW_LNV0 and LAW_Y0: psi stands still there, and v, too, if it is an
 * equilibrium.  Of a law that can be used. */
void law_tape(const struct law *law, bool equilibrium,
              struct tape_lowered *out);

/* The same with the observables of block.h.  Fails with a reason where the
 * law's own formulas cannot be used; *name is that of the one, NULL if it is
 * none alone. */
MUST_CHECK enum status law_tape_observed(const struct law *law,
                                         bool equilibrium,
                                         struct tape_lowered *out,
                                         const char **name, struct fault *why);

/* That of law_tape_observed, of law_names: a composition's is made once and
 * kept as long as the program runs; where there is no memory for it, in
 * *room. */
const struct tape_lowered *law_tape_kept(const struct law *law,
                                         bool equilibrium,
                                         struct tape_lowered *room);
