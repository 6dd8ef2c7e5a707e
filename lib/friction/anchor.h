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

struct anchor {
    double x0, y0;        /* chart coordinates */
    double v0, psi0;      /* slip rate, state = psi_ss(v0) */
    double log_psi0;      /* ln |psi0| */
    double mu0;           /* mu(v0, psi0) */
    double force0;        /* tan(alpha) - mu0: 0 at an equilibrium */
    double a, b;          /* direct and evolution effect */
    double theta_r;       /* psi0/(c' + psi0): weight of psi in theta */
    double theta_s;       /* c'/(c' + psi0) */
    double steady_r;      /* v0/(1/R + v0): weight of v in psi_ss and T */
    double steady_s;      /* (1/R)/(1/R + v0) */
    double log_inertia;   /* ln(cos(alpha)/(eps^2 v0)) */
    double log_rate;      /* ln(1/T(v0)), for (45) ln(1/R); less y0 = ln psi0 */
    double w0;            /* asinh form: mu_log/a */
    double kappa0;        /* v0/V_c */
    double log_composite; /* ln of exp(-v0/V_c)/(v0 psi0), Kato-Tullis */
};

#endif
