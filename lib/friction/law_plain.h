/*
 * law_plain.h -- a law of formulas at any state: its rates with their
 * derivatives by the parameters, and what it has in common with the
 * compositions of the paper, found from its numbers.
 */
#ifndef FRICTION_LAW_PLAIN_H
#define FRICTION_LAW_PLAIN_H

#include "law_typed.h"

/* d(rates of the chart)/d(name of the model or of its own), per t*, at x = ln v
 * and the chart's y; NaN where long doubles do not hold them. */
struct law_plain_slope {
    long double rate[2], slope[2];
};
struct law_plain_slope law_plain_slope(const struct law *law,
                                       const struct material *m,
                                       long double tan_alpha, long double x,
                                       long double y, const char *name);

/* dpsi/dt is -sinh(psi - psi_ss) times what does not depend on psi. */
bool law_plain_is_hyperbolic(const struct law *law, const struct material *m);

/* At c = 0 theta is ln psi but for a constant. */
bool law_plain_theta_is_log(const struct law *law, const struct material *m);

/* psi_ss (1 + R v) does not depend on v. */
bool law_plain_is_spinodal(const struct law *law, const struct material *m);

#endif
