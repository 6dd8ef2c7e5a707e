/*
 * anchor.h -- a point of the steady-state curve, prepared for evaluating the
 * field around it without cancellation.
 *
 * The chart is x = ln v and y = ln psi (y = psi where psi is a logarithm).
 * Offsets X, Y are measured from the anchor (x0, y0), psi0 = psi_ss(v0).
 */
#ifndef FRICTION_ANCHOR_H
#define FRICTION_ANCHOR_H

#include "law.h"

/* The same members for each scalar type T (double, long double, 113 bits). */
#define ANCHOR_MEMBERS(T)                                                      \
    T x0, y0;        /* chart coordinates */                                   \
    T v0, psi0;      /* slip rate, state = psi_ss(v0) */                       \
    T log_psi0;      /* ln |psi0| */                                           \
    T mu0;           /* mu(v0, psi0) */                                        \
    T force0;        /* tan(alpha) - mu0: 0 at an equilibrium */               \
    T a, b;          /* direct and evolution effect */                         \
    T theta_r;       /* psi0/(c' + psi0): weight of psi in theta */            \
    T theta_s;       /* c'/(c' + psi0) */                                      \
    T steady_r;      /* v0/(1/R + v0): weight of v in psi_ss and T */          \
    T steady_s;      /* (1/R)/(1/R + v0) */                                    \
    T log_inertia;   /* ln(cos(alpha)/(eps^2 v0)) */                           \
    T log_rate;      /* ln(1/T(v0)), for (45) ln(1/R); less y0 = ln psi0 */    \
    T kept;          /* e^(what rounding takes from log_inertia - log_rate),   \
                        which may be hundreds: 1 but for the last digits */    \
    T w0, q0;        /* asinh form: w0 = mu_log/a, q0 = 4 exp(-2 w0) */        \
    T kappa0;        /* v0/V_c */                                              \
    T log_kappa0;    /* ln of it */                                            \
    T log_composite; /* ln of exp(-v0/V_c)/(v0 psi0), Kato-Tullis */

struct anchor {
    ANCHOR_MEMBERS(double)
};

#endif
