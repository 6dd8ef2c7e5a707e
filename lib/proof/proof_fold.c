/* mu_ss rises with tau = mu_star + a x + b theta(psi_ss); dtau/dx has the sign
 * of A v^2 + B v + C.  Between two points where that changes its sign tau is
 * least or largest, and near the value that is enclosed over all of them. */
#include "proof_fold.h"

#include "interval_math.h"
#include "proof_short.h"
#include "proof_tolerance.h"
#include "steady.h"

/* ---- tau ----------------------------------------------------------------- */

/* Its theta is the logarithm of (p + q v)/(r + s v), or that itself. */
struct curve {
    struct interval mu_star, a, b, p, q, r, s, A, B, C;
    bool plain;
};

static bool curve_of(const struct law *law, const struct material *m,
                     struct curve *c)
{
    const struct interval zero = point(0), one = point(1);
    const struct interval more = add(one, proof_decimal(m->R));
    const bool unit = law->psi_ss == PSI_SS_SPINODAL_UNIT;
    const bool inverse = law->psi_ss == PSI_SS_INVERSE;
    const struct interval per = law->theta == THETA_LN_C_1PR_PSI ? more : one;
    const struct interval k =
        law->theta == THETA_LN_PSI || law->theta == THETA_PSI
            ? zero
            : proof_decimal(m->c);

    if (law->typed || !(inverse || unit || law->psi_ss == PSI_SS_SPINODAL) ||
        !isfinite(m->R))
        return false;
    c->mu_star = proof_decimal(m->mu_star);
    c->a = proof_decimal(m->a);
    c->b = proof_decimal(m->b);
    c->plain = law->theta == THETA_PSI;
    c->r = inverse ? zero : one;
    c->s = inverse ? one : proof_decimal(m->R);
    c->p = add(times(per, inverse || unit ? one : more), times(k, c->r));
    c->q = times(k, c->s);
    const struct interval ps = times(c->p, c->s), qr = times(c->q, c->r);
    const struct interval fall = times(c->b, interval_less(ps, qr));
    c->A = times(c->a, times(c->plain ? c->s : c->q, c->s));
    c->C = times(c->a, times(c->plain ? c->r : c->p, c->r));
    c->B = c->plain ? times(times(point(2), c->a), times(c->r, c->s))
                    : times(c->a, add(ps, qr));
    c->B = interval_less(c->B, fall);
    return true;
}

static struct interval slope_at(const struct curve *c, long double x)
{
    const struct interval v = interval_exp(point(x));

    return add(c->C, times(v, add(c->B, times(v, c->A))));
}

static struct interval tau_over(const struct curve *c, struct interval x)
{
    const struct interval v = interval_exp(x);
    const struct interval psi =
        interval_divide(add(c->p, times(c->q, v)), add(c->r, times(c->s, v)));
    const struct interval theta = c->plain ? psi : interval_ln(psi);

    return add(c->mu_star, add(times(c->a, x), times(c->b, theta)));
}

/* ---- the slope ----------------------------------------------------------- */

/* tau where mu_ss = tan(alpha): that, or by (4a) a ln(2 sinh(tan(alpha)/a)). */
static struct interval level(const struct curve *c, const struct law *law,
                             const struct proof_inputs *in)
{
    const struct interval t = proof_tangent(in);
    const struct interval part = times(point(-2), interval_divide(t, c->a));

    return law->form == FRICTION_LOG
               ? t
               : add(t, times(c->a, interval_ln(
                                        interval_minus(interval_expm1(part)))));
}

/* ---- all ----------------------------------------------------------------- */

/* Beside an extremum: largest below the level, or least above it. */
static enum proof_alone misses(const struct curve *c, double x,
                               struct interval at, double window[2])
{
    for (double w = PROOF_FOLD_LEAST; w < PROOF_FOLD_MOST; w *= 4) {
        window[0] = x - w;
        window[1] = x + w;
        const struct interval place = { window[0], window[1] };
        const struct interval before = slope_at(c, place.lo);
        const struct interval behind = slope_at(c, place.hi);
        const struct interval tau = tau_over(c, place);
        if (before.lo > 0 && behind.hi < 0 && tau.hi < at.lo)
            return PROOF_ALONE_FAST;
        if (before.hi < 0 && behind.lo > 0 && tau.lo > at.hi)
            return PROOF_ALONE_SLOW;
    }
    return PROOF_ALONE_NOT;
}

enum proof_alone proof_no_saddle(const struct law *law,
                                 const struct material *m,
                                 const struct proof_inputs *in,
                                 double window[2])
{
    enum proof_alone found = PROOF_ALONE_NOT;
    long double x[4];
    struct curve c;

    if (!in->decimal || !curve_of(law, m, &c))
        return PROOF_ALONE_NOT;
    const struct interval four = times(point(4), times(c.A, c.C));
    if (c.B.lo >= 0 || interval_less(four, times(c.B, c.B)).lo > 0)
        return PROOF_ALONE_RISING;
    const struct interval at = level(&c, law, in);
    const size_t n = steady_extrema(law, m, x);
    for (size_t i = 0; i < n && found == PROOF_ALONE_NOT; i++)
        found = misses(&c, (double) x[i], at, window);
    return found;
}

bool proof_rises_through(const struct law *law, const struct material *m)
{
    struct curve c;

    if (!curve_of(law, m, &c))
        return false;
    const bool steep = interval_less(c.a, c.b).lo > 0;
    return (steep || c.r.lo > 0) && (steep || c.plain || c.q.lo > 0);
}
