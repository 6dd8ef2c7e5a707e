/* ode.h -- a small system of ordinary differential equations. */
#pragma once

#include "curve.h"

/* u' = du/ds = rhs(s, u) of dimension dim <= CURVE_DIM_MAX.  Where rhs is not
 * defined it writes NaN, which makes the integrator shorten its step. */
struct ode {
    size_t dim;
    void (*rhs)(const void *ctx, double s, const double u[], double du[]);
    const void *ctx; /* borrowed */
};
