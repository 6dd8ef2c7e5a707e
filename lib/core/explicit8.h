/*
 * explicit8.h -- one step of Dormand and Prince's explicit Runge-Kutta method
 * of order 8 with error estimates of order 5 and 3 and dense output of order
 * 7: Hairer, Norsett & Wanner, Solving ODEs I (1993), sec. II.5, II.6.
 */
#pragma once

#include "ode.h"

enum {
    EXPLICIT8_DEGREE = 7,
    EXPLICIT8_CALLS = 11,
    EXPLICIT8_TERMS = 3 /* estimates of last terms (explicit8_table.h) */
};

/* The stages; k[0] = rhs(s, u) is the caller's to fill. */
struct explicit8 {
    double k[16][CURVE_DIM_MAX];
};

/* From (s, u) to s + h: u1.  Returns the root mean square over the components
 * of the estimated error over atol_i + rtol max(|u_i|, |u1_i|), which may be
 * NaN; `error`: the estimates themselves, unsigned, of order 5. */
double explicit8_try(struct explicit8 *w, const struct ode *ode, double s,
                     const double u[], double h, const double atol[],
                     double rtol, double u1[], double error[]);

/* After explicit8_try with the same arguments: the polynomial in theta, with
 * theta = 0 at u and 1 at u1, as coef[i * (EXPLICIT8_DEGREE + 1) + j].  Leaves
 * rhs(s + h, u1) in k[12]. */
void explicit8_dense(struct explicit8 *w, const struct ode *ode, double s,
                     const double u[], double h, const double u1[],
                     double coef[]);
