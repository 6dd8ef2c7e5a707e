/* ode.h -- a small system of ordinary differential equations. */
#pragma once

#include <stdbool.h>

#include "curve.h"

/* u' = du/ds = rhs(s, u) of dimension dim <= CURVE_DIM_MAX.  Where rhs is not
 * defined it writes NaN, which makes the integrator shorten its step. */
struct ode {
    size_t dim;
    void (*rhs)(const void *ctx, double s, const double u[], double du[]);
    const void *ctx; /* borrowed */
};

/* Whether each of n numbers is. */
static inline bool ode_all_finite(const double u[], size_t n)
{
    double sum = 0.0;

    for (size_t i = 0; i < n; i++)
        sum += 0.0 * u[i];
    return sum == 0.0;
}
