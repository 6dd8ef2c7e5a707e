/*
 * response.h -- how friction answers to a small change of slip rate about
 * steady sliding, from the law's formulas and in long double: near an extremum
 * of mu_ss every digit counts.
 */
#pragma once

#include "law.h"

/* At x = ln v on the steady-state curve. */
struct response {
    long double slope;  /* d mu_ss/d ln v, at psi = psi_ss(v) */
    long double direct; /* d mu/d ln v at fixed psi: > 0 */
    long double rate;   /* -d(dpsi/dt)/dpsi at fixed v, per L/V_star: > 0, the
                           inverse of the state's time scale t_*(v) */
    long double slope_error; /* bound on what rounding does to slope */
    long double rate_error;  /* the same of rate, relative */
};

/* x below steady_x_max(law) (steady.h). */
struct response response_at(const struct law *law, const struct material *m,
                            long double x);
