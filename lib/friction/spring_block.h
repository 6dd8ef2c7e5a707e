/*
 * spring_block.h -- where the steady sliding of a block pulled through a
 * spring loses its stability (Putelat & Dawes 2015, Fig 1(b) and the end of
 * section 2; Rice & Ruina 1983, J. Appl. Mech. 50, 343-349).
 *
 * A block of areal mass m under the normal stress sigma, pulled at the speed V
 * through a spring of stiffness k per area, with s the slip it lags behind:
 *
 *     ds/dt = V - V_b,  m dV_b/dt = k s - sigma mu(V_b, phi),
 *     dphi/dt = -G(V_b, phi).
 *
 * With g = dG/dphi = 1/t_*(V) in steady state, the characteristic polynomial
 *
 *     m l^3 + (sigma mu_v + m g) l^2 + (k + sigma g mu_ss') l + k g
 *
 * has all roots to the left where k > k_c (Routh & Hurwitz), and a pair on the
 * imaginary axis at
 *
 *     k_c(V) = -sigma mu_ss'(V) g (1 + m g/(sigma mu_v)),
 *
 * ' and _v by the dimensional V.  Below k_c: stick-slip.  Where mu_ss' >= 0 no
 * spring is soft enough.  For `dieterich` and m = 0: sigma (b - a)/L.
 */
#pragma once

#include "law.h"

struct spring_block {
    double sigma; /* Pa, > 0 */
    double mass;  /* kg/m^2, >= 0 */
};

struct spring_limit {
    long double k;              /* Pa/m; <= 0: stable at any stiffness */
    long double k_quasistatic;  /* the same at m = 0 */
    long double relative_error; /* of both, a bound: rounding */
};

/* At v = V/V_star = exp(x), x below steady_x_max(law) (steady.h). */
struct spring_limit spring_block_limit(const struct spring_block *block,
                                       const struct law *law,
                                       const struct material *m, long double x);
