/* exact_anchor.h -- a point of the steady-state curve and what closed forms of
 * the field around it are made of, in 113 bits, from the model as it is printed
 * (plain.h).  Names as in steady.h. */
#pragma once

#include "plain.h"

struct exact_anchor {
    quad x0, y0, v0, psi0, log_psi0, mu0, force0, a, b;
    quad theta_r, theta_s, steady_r, steady_s;
    quad log_inertia, log_rate;
    quad w0, q0; /* mu_log/a, 4 exp(-2 w0) */
    quad kappa0, log_kappa0, log_composite;
};

/* c as it stands beside psi */
static inline quad exact_offset(const struct law *law, const struct material *m)
{
    return law->theta == THETA_LN_C_PSI       ? (quad) m->c
           : law->theta == THETA_LN_C_1PR_PSI ? (quad) m->c / (1 + (quad) m->R)
                                              : 0;
}

/* `equilibrium`: force0 is zero by construction. */
static inline struct exact_anchor exact_anchor_at(const struct law *law,
                                                  const struct material *m,
                                                  quad tan_alpha, quad x,
                                                  bool equilibrium)
{
    const bool is_log = law_psi_is_log(law);
    const quad psi = plain_psi_ss(law, m, x), y = is_log ? psi : logq(psi),
               mu = equilibrium ? tan_alpha : plain_mu(law, m, x, psi);
    const quad a = m->a, v = expq(x), r = 1 / plain_R(m),
               c = exact_offset(law, m), k = v / (quad) m->V_c,
               w = plain_mu_log(law, m, x, psi) / a;
    const quad V = m->V_star, eps2 = V * V / ((quad) m->g * (quad) m->L);

    return (struct exact_anchor){
        .x0 = x,
        .y0 = y,
        .v0 = v,
        .psi0 = psi,
        .log_psi0 = is_log ? logq(fabsq(psi)) : y,
        .mu0 = mu,
        .force0 = tan_alpha - mu,
        .a = a,
        .b = m->b,
        .theta_r = c > 0 ? psi / (c + psi) : 1,
        .theta_s = c > 0 ? c / (c + psi) : 0,
        .steady_r = v / (r + v),
        .steady_s = r / (r + v),
        .log_inertia = -logq(eps2) - log1pq(tan_alpha * tan_alpha) / 2 - x,
        .log_rate =
            -(law_freezes(law) ? logq(plain_R(m)) : plain_log_T(law, m, x)) -
            (is_log ? 0 : y),
        .w0 = w,
        .q0 = 4 * expq(-2 * w),
        .kappa0 = k,
        .log_kappa0 = logq(k),
        .log_composite = -k - x - y,
    };
}
