/* plain.h -- the model as it is printed, in 113 bits and absolute
 * coordinates: no anchor, no care for cancellation.  The second opinion on
 * everything lib/friction computes. */
#pragma once

#include <math.h>

#include "law.h"
#include "quad.h"

/* R = inf stands for a number so large that no digit tells. */
static inline quad plain_R(const struct material *m)
{
    return isinf(m->R) ? expq(4000) : (quad) m->R;
}

/* u = W(e^-k): u e^u = e^-k, by bisection between e^(-k-1) and e^-k. */
static inline quad plain_lambert(quad k)
{
    quad lo = expq(-k - 1), hi = expq(-k);

    for (int i = 0; i < 120; i++) {
        const quad mid = (lo + hi) / 2;
        if (mid < expq(-k - mid))
            lo = mid;
        else
            hi = mid;
    }
    return hi;
}

static inline quad plain_psi_ss(const struct law *law, const struct material *m,
                                quad x)
{
    const quad v = expq(x), R = plain_R(m);

    switch (law->psi_ss) {
        case PSI_SS_INVERSE:
            return 1 / v;
        case PSI_SS_MINUS_LOG:
            return -x;
        case PSI_SS_SPINODAL:
            return (1 + R) / (1 + R * v);
        case PSI_SS_SPINODAL_UNIT:
            return 1 / (1 + R * v);
        default:
            return expq(plain_lambert(v / (quad) m->V_c)) / v;
    }
}

static inline quad plain_theta(const struct law *law, const struct material *m,
                               quad psi)
{
    switch (law->theta) {
        case THETA_LN_PSI:
            return logq(psi);
        case THETA_PSI:
            return psi;
        case THETA_LN_C_PSI:
            return logq((quad) m->c + psi);
        default:
            return logq((quad) m->c + (1 + plain_R(m)) * psi);
    }
}

/* (2), and (4a) where law->form says so */
static inline quad plain_mu_log(const struct law *law, const struct material *m,
                                quad x, quad psi)
{
    return (quad) m->mu_star + (quad) m->a * x +
           (quad) m->b * plain_theta(law, m, psi);
}

static inline quad plain_mu(const struct law *law, const struct material *m,
                            quad x, quad psi)
{
    const quad a = (quad) m->a, mu_log = plain_mu_log(law, m, x, psi);

    if (law->form == FRICTION_LOG || mu_log / a > 5000)
        return mu_log;
    return a * asinhq(expq(mu_log / a) / 2);
}

static inline quad plain_mu_ss(const struct law *law, const struct material *m,
                               quad x)
{
    return plain_mu(law, m, x, plain_psi_ss(law, m, x));
}

/* ln T */
static inline quad plain_log_T(const struct law *law, const struct material *m,
                               quad x)
{
    const quad R = plain_R(m);

    switch (law->timescale) {
        case TIMESCALE_SLIP:
            return -x;
        case TIMESCALE_SPINODAL:
            return logq(R / (1 + R * expq(x)));
        case TIMESCALE_AGEING44:
            return logq(R * plain_psi_ss(law, m, x));
        default:
            return logq(R) + plain_psi_ss(law, m, x);
    }
}

/* A number too large for any format: sign and ln of the magnitude. */
struct plain_number {
    int sign;
    quad log_abs;
};

static inline struct plain_number plain_number(quad mantissa, quad exponent)
{
    return (struct plain_number){ (mantissa > 0) - (mantissa < 0),
                                  logq(fabsq(mantissa)) + exponent };
}

/* d ln v/dt = (sin(alpha) - cos(alpha) mu)/(eps^2 v), (17) */
static inline struct plain_number plain_fx(const struct law *law,
                                           const struct material *m,
                                           quad tan_alpha, quad x, quad y)
{
    const quad psi = law_psi_is_log(law) ? y : expq(y);
    const quad cosine = 1 / sqrtq(1 + tan_alpha * tan_alpha);
    const quad eps2 =
        (quad) m->V_star * (quad) m->V_star / ((quad) m->g * (quad) m->L);

    return plain_number(tan_alpha * cosine - cosine * plain_mu(law, m, x, psi),
                        -logq(eps2) - x);
}

/* d ln psi/dt, or dpsi/dt where psi is a logarithm */
static inline struct plain_number plain_fy(const struct law *law,
                                           const struct material *m, quad x,
                                           quad y)
{
    const bool is_log = law_psi_is_log(law);
    const quad psi = is_log ? y : expq(y), v = expq(x);

    if (law->kinetics == KINETICS_COMPOSITE)
        return plain_number(expq(-v / (quad) m->V_c) - v * psi * logq(v * psi),
                            -y);
    const quad d = psi - plain_psi_ss(law, m, x);
    const quad exponent = -plain_log_T(law, m, x) - (is_log ? 0 : y);
    if (law->kinetics == KINETICS_LINEAR)
        return plain_number(-d, exponent);
    if (fabsq(d) > 100)
        return plain_number(d > 0 ? -1 : 1, exponent + fabsq(d) - logq(2));
    return plain_number(-sinhq(d), exponent);
}
