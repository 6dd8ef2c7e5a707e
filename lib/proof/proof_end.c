#include "proof_end.h"

#include "proof_flow.h"
#include "proof_tolerance.h"

static struct interval point(double x)
{
    return interval_point(x);
}

static struct interval times(struct interval u, struct interval w)
{
    return interval_times(u, w);
}

static struct interval add(struct interval u, struct interval w)
{
    return interval_add(u, w);
}

struct proof_place proof_place_on(const struct proof_piece *p,
                                  struct interval theta, double error, int side)
{
    const struct interval at =
        add(point(p->start), times(point(p->step), theta));
    const struct interval dep =
        add(proof_poly_at(p->degree, p->coef, theta), interval_within(error));

    return p->ind == 0 ? (struct proof_place){ at, dep, side }
                       : (struct proof_place){ dep, at, side };
}

/* |mu - tan(alpha)| at the place, on its side. */
static struct interval force_at(struct proof_law *p,
                                const struct proof_place *at)
{
    const struct interval change = interval_tape_change(&p->tape, at->X, at->Y);

    return at->side > 0 ? change : interval_minus(change);
}

static struct interval psi_at(const struct proof_law *p, struct interval Y)
{
    return p->is_log ? add(p->psi, Y) : times(p->psi, interval_exp(Y));
}

/* |psi - psi_ss(v)|, likewise. */
static bool lag_at(struct proof_law *p, const struct proof_place *at,
                   struct interval *lag, struct interval *rate)
{
    struct interval psi_ss;

    if (!proof_law_steady(p, add(p->x, at->X), &psi_ss, rate))
        return false;
    const struct interval d = interval_less(psi_at(p, at->Y), psi_ss);
    *lag = at->side > 0 ? d : interval_minus(d);
    return true;
}

bool proof_is_outward(struct proof_law *p, const struct proof_place *at)
{
    struct interval lag, rate;

    return force_at(p, at).lo > 0 && lag_at(p, at, &lag, &rate) && lag.lo > 0;
}

static struct interval kinetics(const struct proof_law *p, struct interval d)
{
    return p->first_order ? d : interval_sinh(d);
}

/* 2 e^-d/(1 - e^(-2 d)) >= integral_0^inf t^k/k!/sinh(d + t) dt, k = 0, 1, for
 * sinh(d + t) >= e^(d + t) (1 - e^(-2 d))/2. */
static struct interval over_sinh(struct interval d)
{
    const struct interval e = interval_exp(interval_minus(d));

    return interval_divide(times(point(2), e),
                           interval_less(point(1), times(e, e)));
}

/* What the tails in psi have in common. */
struct facts {
    struct interval force;  /* |mu - tan(alpha)| at the place, its upper end */
    double more;            /* of it where psi has settled the integral */
    struct interval weight; /* integral of |d psi|/K over the tail */
};

/* Upper: x in [x1, x1 + w], psi >= Psi, d >= psi - psi_ss(v1) = D + psi - Psi,
 * mu - mu1 <= a w + b (psi - Psi)/Psi, or b (psi - Psi) if psi is a logarithm.
 * Lower: x in [x1 - w, x1], psi <= Psi, |d| >= psi_ss(v1) - psi >= D, and mu1 -
 * mu <= a w + b ln(Psi/psi), whose integral over 0 < psi <= Psi is b Psi; if
 * psi is a logarithm as above. */
static bool facts_of(struct proof_law *p, const struct proof_place *at,
                     struct interval lag, struct facts *out)
{
    const struct interval psi = psi_at(p, at->Y);
    const struct interval d = interval_low(lag);

    if (!(d.lo > 0))
        return false;
    out->force = interval_high(force_at(p, at));
    if (at->side > 0 || p->is_log) {
        if (p->first_order)
            return false;
        out->weight = over_sinh(d);
        out->more =
            p->is_log ? p->b.hi : interval_divide(p->b, interval_low(psi)).hi;
    } else {
        out->weight = interval_divide(interval_high(psi), kinetics(p, d));
        out->more = p->b.hi;
    }
    return interval_is_finite(out->weight) && isfinite(out->more);
}

/* |dx| <= F/(v rate) (m + a w + more) weight where v and rate are the least on
 * the way, of w at most. */
static bool way_for(struct proof_law *p, const struct proof_place *at, double w,
                    const struct facts *f, struct proof_tail *out)
{
    struct interval psi_ss, rate;
    const struct interval least =
        at->side > 0 ? interval_low(at->X)
                     : interval_less(interval_low(at->X), point(w));
    const struct interval x = add(p->x, least);

    if (!proof_law_steady(p, interval_low(x), &psi_ss, &rate))
        return false;
    const struct interval m =
        add(f->force, add(times(p->a, point(w)), point(f->more)));
    const struct interval per =
        interval_divide(times(p->force, interval_exp(interval_minus(x))), rate);
    const struct interval change = interval_expm1(
        at->side > 0 ? add(interval_high(at->X), point(w)) : least);

    out->way = times(times(per, m), f->weight).hi;
    out->excess = interval_most(
        times(times(p->v, change), interval_divide(f->weight, rate)));
    return isfinite(out->way) && isfinite(out->excess);
}

bool proof_tail_psi(struct proof_law *p, const struct proof_place *at,
                    struct proof_tail *out)
{
    struct interval lag, rate;
    struct facts f;
    double w = 0;

    if (!proof_is_outward(p, at) || !lag_at(p, at, &lag, &rate) ||
        !facts_of(p, at, lag, &f))
        return false;
    for (int i = 0; i < PROOF_END_TRIES && w < 1; i++) {
        if (!way_for(p, at, w, &f, out))
            return false;
        if (out->way < w)
            return true;
        w = 2 * out->way + PROOF_END_LEAST;
    }
    return false;
}

/* ---- v = 0 --------------------------------------------------------------- */

/* At least K(psi_ss(v) - psi)/T(v) for all v <= v1 and psi >= Psi:
 *   psi_ss bounded: K(psi_ss(0) - Psi)/T(v1);
 *   1/T = r v, psi_ss = -ln v: sinh(-ln v - Psi) v <= e^-Psi/2, and of first
 *   order (-ln v - Psi) v <= e^(-1 - Psi);
 *   1/T = r v, psi_ss = 1/v, of first order: (1/v - Psi) v <= 1 for Psi >= 0.
 */
static bool growth_below(const struct proof_law *p, const struct law *law,
                         struct interval psi, struct interval v,
                         struct interval rate, struct interval *out)
{
    const struct interval low = interval_minus(interval_low(psi));
    const struct interval r = interval_divide(rate, v);
    const bool by_v =
        law->timescale == TIMESCALE_SLIP ||
        (law->timescale == TIMESCALE_AGEING44 && p->form == PSI_SS_INVERSE) ||
        (law->timescale == TIMESCALE_SLIP45 && p->form == PSI_SS_MINUS_LOG);

    if (p->form == PSI_SS_SPINODAL || p->form == PSI_SS_SPINODAL_UNIT) {
        const struct interval top =
            p->form == PSI_SS_SPINODAL ? add(point(1), p->R) : point(1);
        *out = times(kinetics(p, add(top, low)), rate);
        return add(top, low).lo > 0;
    }
    if (!by_v)
        return false;
    if (p->form == PSI_SS_MINUS_LOG) {
        *out = p->first_order ? times(r, interval_exp(add(low, point(-1))))
                              : times(r, times(point(0.5), interval_exp(low)));
        return true;
    }
    *out = r;
    return p->first_order && p->form == PSI_SS_INVERSE;
}

/* |d psi| <= S e^x1/(F m) where psi >= Psi - w: d psi/dx = (K/T) v/(F |mu -
 * tan(alpha)|), and |mu - tan(alpha)| grows on the way. */
static bool way_to_0(struct proof_law *p, const struct law *law,
                     const struct proof_place *at, double w,
                     struct proof_tail *out)
{
    const struct interval x = interval_high(add(p->x, interval_high(at->X)));
    const struct interval Y = interval_less(interval_low(at->Y), point(w));
    const struct interval v = interval_exp(x), psi = psi_at(p, Y);
    const struct interval force = interval_low(force_at(p, at));
    struct interval psi_ss, rate, most;

    if (!proof_law_steady(p, x, &psi_ss, &rate) ||
        !growth_below(p, law, psi, v, rate, &most))
        return false;
    const struct interval time =
        interval_divide(v, times(p->force, force)); /* to v = 0, at most */
    struct interval way = times(most, time);
    if (!p->is_log)
        way = interval_divide(way, interval_low(psi));
    out->way = way.hi;
    out->excess = times(p->v, time).hi;
    return isfinite(out->way) && isfinite(out->excess);
}

bool proof_tail_v(struct proof_law *p, const struct law *law,
                  const struct proof_place *at, struct proof_tail *out)
{
    double w = 0;

    if (at->side > 0 || !proof_is_outward(p, at))
        return false;
    for (int i = 0; i < PROOF_END_TRIES && w < 1; i++) {
        if (!way_to_0(p, law, at, w, out))
            return false;
        if (out->way < w)
            return true;
        w = 2 * out->way + PROOF_END_LEAST;
    }
    return false;
}
