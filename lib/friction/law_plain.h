/*
 * law_plain.h -- what a law of formulas has in common with the compositions of
 * the paper, found from its numbers.
 */
#ifndef FRICTION_LAW_PLAIN_H
#define FRICTION_LAW_PLAIN_H

#include "law.h"

/* dpsi/dt is -sinh(psi - psi_ss) times what does not depend on psi. */
bool law_plain_is_hyperbolic(const struct law *law, const struct material *m);

/* At c = 0 theta is ln psi but for a constant. */
bool law_plain_theta_is_log(const struct law *law, const struct material *m);

/* psi_ss (1 + R v) does not depend on v. */
bool law_plain_is_spinodal(const struct law *law, const struct material *m);

#endif
