/* condition.h -- what rounding must cost the field: 2^-53 times the condition
 * number of each component, in which a sum costs its largest term over its
 * value and an exponent its own size. */
#pragma once

#include "plain.h"
#include "setting.h"

#define ULP 0x1p-53

/* Condition numbers: relative error of each component in units of 2^-53. */
struct condition {
    quad x, y;
    quad log_slope; /* how fast the exponents change */
};

static inline quad condition_of_mu(const struct setting *s, quad X, quad Y)
{
    const struct exact_anchor *at = &s->hand;
    const quad psi0 = law_psi_is_log(&s->law) ? at->psi0 : expq(at->y0);
    const quad psi = law_psi_is_log(&s->law) ? at->y0 + Y : expq(at->y0 + Y);
    const quad theta =
        plain_theta(&s->law, &s->m, psi) - plain_theta(&s->law, &s->m, psi0);
    const quad terms =
        at->a * fabsq(X) + at->b * (fabsq(theta) + (Y > 700 ? Y : 0));
    const quad u = X + at->b / at->a * theta, w = at->w0 + u;
    const quad mu = plain_mu(&s->law, &s->m, at->x0 + X, psi) -
                    plain_mu(&s->law, &s->m, at->x0, psi0);

    if (s->law.form == FRICTION_LOG || (at->w0 > 0.7 && w > 0.7))
        return terms;
    /* exp(w), exp(w0): exponents cost their size; where friction weakens
     * exponentially, an error of u weighs no more than the change of mu */
    const quad slope = 1 / sqrtq(1 + 4 * expq(-2 * (w < 0 ? w : 0)));
    return slope * terms + fabsq(mu) * (fabsq(at->w0) + fabsq(w));
}

static inline quad condition_of_composite(const struct setting *s, quad X,
                                          quad Y, struct condition *c)
{
    const struct exact_anchor *at = &s->hand;
    const quad k = at->kappa0 * expq(X), z0 = at->x0 + at->y0, z = z0 + X + Y;
    const quad E = expq(-k - z), E0 = z0;
    const quad size = 1 + fabsq(X) + fabsq(Y) + fabsq(at->log_composite) +
                      fabsq(k - at->kappa0) * (1 + fabsq(at->log_kappa0 + X));
    const quad sum = fabsq(E - E0) + E0 + fabsq(X) + fabsq(Y);

    c->log_slope += k;
    return (sum + (E + E0) * size) / fabsq(E - z) + fabsq(k + z) + fabsq(X);
}

/* psi - psi_ss and the exponents around it. */
static inline quad condition_of_lag(const struct setting *s, quad X, quad Y,
                                    struct condition *c)
{
    const struct exact_anchor *at = &s->hand;
    const quad x = at->x0 + X, y = at->y0 + Y;
    const bool is_log = law_psi_is_log(&s->law);
    const bool ss_is_log = s->law.psi_ss == PSI_SS_MINUS_LOG;
    const quad psi = is_log ? y : expq(y);
    const quad psi_ss = plain_psi_ss(&s->law, &s->m, x), d = psi - psi_ss;
    const quad size = 1 + fabsq(at->y0) + fabsq(at->log_psi0) + fabsq(Y) +
                      fabsq(at->x0) + fabsq(X);
    quad lag;

    if (is_log && ss_is_log)
        lag = (fabsq(X) + fabsq(Y)) / fabsq(d);
    else if (is_log)
        lag = (fabsq(Y) +
               (psi_ss + at->psi0 * fabsq(psi_ss / at->psi0 - 1)) * size) /
              fabsq(d);
    else if (ss_is_log)
        lag = ((psi + fabsq(psi - at->psi0)) * size + fabsq(X)) / fabsq(d);
    else /* ln(psi/psi_ss) is rounded to the size of its parts */
        lag = 1 + fabsq(X) + fabsq(Y) +
              (fabsq(X) + fabsq(Y)) / fabsq(expm1q(-fabsq(logq(psi / psi_ss))));
    c->log_slope += fabsq(psi) + fabsq(psi_ss);
    if (s->law.kinetics == KINETICS_SINH)
        lag *= 1 + fabsq(d);
    if (law_freezes(&s->law))
        lag += size * (fabsq(psi) +
                       (s->law.kinetics == KINETICS_SINH ? fabsq(d) : psi_ss));
    return lag + size + fabsq(at->log_rate);
}

static inline struct condition condition_at(const struct setting *s, quad X,
                                            quad Y, quad log_scale)
{
    const struct exact_anchor *at = &s->hand;
    const quad psi = law_psi_is_log(&s->law) ? at->y0 + Y : expq(at->y0 + Y);
    const quad force =
        fabsq(s->exact_tan - plain_mu(&s->law, &s->m, at->x0 + X, psi));
    const quad terms = fabsq(at->force0) + condition_of_mu(s, X, Y);
    struct condition c = { .log_slope = 1 };

    c.x = 1 + fabsq(at->log_inertia) + fabsq(X) + fabsq(log_scale) +
          terms / force;
    c.y = 1 + fabsq(log_scale) +
          (s->law.kinetics == KINETICS_COMPOSITE
               ? condition_of_composite(s, X, Y, &c)
               : condition_of_lag(s, X, Y, &c));
    return c;
}

/* ln |p exp(l)| - ln |q exp(r)|, huge if the signs differ. */
static inline quad log_ratio(quad p, quad l, quad q, quad r)
{
    if (p == q && p == 0)
        return 0;
    if (!(p * q > 0)) /* both are O(1) or one has underflown */
        return HUGE_VAL;
    return logq(p / q) + (l - r);
}
