/*
 * law_tape.h -- a block on a slope, (17), from the formulas of its law as
 * people type them, lowered to differences from a steady state (tape.h).
 */
#ifndef FRICTION_LAW_TAPE_H
#define FRICTION_LAW_TAPE_H

#include "law.h"
#include "tape_plane.h"

/* Rates of the chart (ln v, ln psi) or (ln v, psi) per t*; value 0 is mu.
 * out->f must know the constants tan_alpha, mu_star, a, b, c, R, one_R (1/R: R
 * may be infinite), V_c, eps2 and lnv0, where the steady curve is left from:
 * psi stands still there, and v, too, if it is an equilibrium. */
void law_tape(const struct law *law, bool equilibrium,
              struct tape_lowered *out);

/* The same with the observables of block.h.  Fails with a reason where the
 * law's own formulas cannot be used; *name is that of the one, NULL if it is
 * none alone. */
MUST_CHECK enum status law_tape_observed(const struct law *law,
                                         bool equilibrium,
                                         struct tape_lowered *out,
                                         const char **name, struct fault *why);

#endif
