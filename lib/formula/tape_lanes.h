/*
 * tape_lanes.h -- the rates of the chart of several points side by side
 * (lanes.h; define LANES before): the steps of a tape (tape.h) over lanes, each
 * what doubles make of its point, to rounding; over two sets of lanes at once,
 * so that one can wait while the other is computed.  Where doubles branch on
 * values, the rarer branch is skipped unless a lane needs it, and chosen lane
 * by lane.
 */
#pragma once

#include "lanes.h"
#include "real_tape.h"

/* ---- steps --------------------------------------------------------------- */

/* p (e^u - 1), l = u + ln p; p = 0, in all lanes: e^l */
static inline lanes tape_lanes_growth(lanes p, lanes l, lanes u)
{
    const lanes none = LANES_OF(0.0), one = LANES_OF(1.0);

    if (!lanes_any_less(none, p))
        return lanes_exp(l);
    const lanes near = p * lanes_em1(u);
    if (!lanes_any_less(one, u))
        return near;
    return lanes_less(one, u, lanes_exp(l) - p, near);
}

/* p (e^u - e^w) */
static inline lanes tape_lanes_apart(double p, lanes u, lanes w)
{
    const lanes half = lanes_exp(0.5 * lanes_larger(u, w));
    const lanes less = lanes_em1(-lanes_size(u - w));

    return p * half * half * lanes_less(w, u, -less, less);
}

/* ln(r e^u + s), r + s = 1 */
static inline lanes tape_lanes_mixed(double r, double s, lanes u)
{
    const lanes far = LANES_OF(700.0), none = LANES_OF(0.0);

    if (!(s < 0.0 || s > 0.0))
        return u;
    lanes e;
    const lanes change = r * lanes_em1_exp(u, &e), sum = s + r * e;
    lanes out = lanes_ln_near(
        lanes_less(change, LANES_OF(-0.5), sum, 1.0 + change), change);
    if (lanes_any_less(far, u))
        out = lanes_less(far, u, u + log(r), out);
    if (r < 0.0 || s < 0.0)
        out = lanes_less(none, sum, out, LANES_OF(NAN));
    return out;
}

/* asinh(e^w/2) for any w. */
static inline lanes tape_lanes_asinh_exp(lanes w)
{
    const lanes t = 0.5 * lanes_exp(w), root = lanes_root(1.0 + t * t);
    const lanes near = lanes_ln1p(t + t * t / (1.0 + root));
    const lanes q = 4.0 * lanes_exp(-2.0 * w);
    const lanes far = w + lanes_ln1p(0.5 * (lanes_root(1.0 + q) - 1.0));

    return lanes_less(LANES_OF(1.0), w, far, near);
}

/* scalar_friction where e^w0 or e^(w0 + u) is not large. */
static inline lanes tape_lanes_slight_friction(double w0, lanes u)
{
    const double t0 = 0.5 * exp(w0), root0 = sqrt(1.0 + t0 * t0);
    const lanes e = lanes_exp(u), t = t0 * e;
    const lanes s =
        t0 * lanes_em1(2.0 * u) / (e * root0 + lanes_root(1.0 + t * t));
    const lanes size = lanes_size(s), root = lanes_root(1.0 + size * size);
    const lanes near =
        lanes_signed(lanes_ln1p(size + size * size / (1.0 + root)), s);
    const lanes far =
        tape_lanes_asinh_exp(w0 + u) - tape_lanes_asinh_exp(LANES_OF(w0));

    return lanes_less(lanes_size(u), LANES_OF(1.0), near, far);
}

/* scalar_friction where both are: e^(-2 w) is e^(-2 w0) e^(-2 u) unless the
 * second overflows. */
static inline lanes tape_lanes_fair_friction(double w0, double q0, lanes u)
{
    const double s0 = sqrt(1.0 + q0);
    const lanes far = LANES_OF(-300.0);
    lanes change = q0 * lanes_em1(-2.0 * u), q = q0 + change;

    if (w0 > 300.0 && lanes_any_less(u, far)) {
        const lanes own = 4.0 * lanes_exp(-2.0 * (w0 + u));
        change = lanes_less(u, far, -own * lanes_em1(2.0 * u), change);
        q = lanes_less(u, far, own, q);
    }
    return u + lanes_ln1p(change / ((lanes_root(1.0 + q) + s0) * (1.0 + s0)));
}

/* Where both are huge, beyond 2^59, the asinh is the logarithm. */
static inline lanes tape_lanes_friction(double w0, double q0, lanes u)
{
    const lanes fair = LANES_OF(0.7), huge = LANES_OF(20.5);
    const lanes least = lanes_smaller(w0 + u, LANES_OF(w0));
    lanes out = u;

    if (w0 < 20.5 || lanes_any_less(least, huge))
        out = tape_lanes_fair_friction(w0, q0, u);
    if (lanes_any_less(least, fair))
        out = lanes_less(least, fair, tape_lanes_slight_friction(w0, u), out);
    return out;
}

/* ---- registers ----------------------------------------------------------- */

enum { TAPE_SETS = 2 };

/* Of both sets. */
struct tape_lanes {
    const struct real_tape *t;
    lanes reg[TAPE_STEPS + 2][TAPE_SETS];
};

/* Those that have no lanes of their own, one by one. */
static inline lanes tape_lanes_function(const struct real_tape *t, int i,
                                        lanes u)
{
    double reg[TAPE_STEPS + 2];

    for (int l = 0; l < LANES; l++) {
        reg[t->step[i].a] = u[l];
        u[l] = real_tape_step(t, i, 0, reg);
    }
    return u;
}

static inline void tape_lanes_linear(const struct tape_lanes *v,
                                     const struct real_tape_form *u,
                                     lanes out[])
{
    const struct real_tape_term *at = &v->t->term[u->first], *const end =
                                                                 at + u->terms;
    lanes sum[TAPE_SETS];

    for (int p = 0; p < TAPE_SETS; p++)
        sum[p] = LANES_OF(u->constant);
    for (; at < end; at++)
        for (int p = 0; p < TAPE_SETS; p++)
            sum[p] += at->c * v->reg[at->reg][p];
    for (int p = 0; p < TAPE_SETS; p++)
        out[p] = sum[p];
}

/* The s of a scaled step. */
static inline lanes tape_lanes_scale(const struct tape_lanes *v, int i, int p)
{
    const struct real_tape *t = v->t;
    const struct real_tape_form *form = &t->step[i].form;
    lanes s = LANES_OF(0.0);

    for (int j = form->first; j < form->first + form->terms; j++) {
        const int g = t->term[j].reg - 2;
        if (!real_tape_grows(t, g + 2))
            continue;
        const struct real_tape_entry *n = &t->step[g];
        const lanes u = v->reg[n->a][p];
        if (n->kind == STEP_APART)
            s = lanes_larger(s, lanes_larger(u, v->reg[n->b][p] + n->q));
        else
            s = lanes_larger(s, n->b >= 0 ? v->reg[n->b][p] : n->q + u);
    }
    return s;
}

/* A growth or an apart times e^-s. */
static inline lanes tape_lanes_grown(const struct tape_lanes *v, int i, int p,
                                     lanes s, lanes k)
{
    const struct real_tape_entry *n = &v->t->step[i];
    const lanes u = v->reg[n->a][p];

    if (n->kind == STEP_APART)
        return tape_lanes_apart(n->k, u - s, v->reg[n->b][p] + n->q - s);
    return tape_lanes_growth(k, (n->b >= 0 ? v->reg[n->b][p] : n->q + u) - s,
                             u);
}

static inline lanes tape_lanes_scaled(const struct tape_lanes *v, int i, int p)
{
    const struct real_tape *t = v->t;
    const struct real_tape_form *form = &t->step[i].form;
    const lanes s = tape_lanes_scale(v, i, p), less = lanes_exp(-s);
    lanes sum = form->constant * less;

    for (int j = form->first; j < form->first + form->terms; j++) {
        const int r = t->term[j].reg;
        if (!real_tape_grows(t, r)) {
            sum += t->term[j].c * (v->reg[r][p] * less);
            continue;
        }
        lanes k = LANES_OF(t->step[r - 2].k);
        if (real_tape_takes(t, r))
            k = lanes_less(LANES_OF(0.0), s, lanes_exp(t->step[r - 2].q - s),
                           k);
        sum += t->term[j].c * tape_lanes_grown(v, r - 2, p, s, k);
    }
    return sum;
}

static inline lanes tape_lanes_sinh(lanes u)
{
    return lanes_signed(0.5 * lanes_em1(-2.0 * lanes_size(u)), u);
}

static inline void tape_lanes_step(struct tape_lanes *v, int i)
{
    const struct real_tape_entry *n = &v->t->step[i];
    const double k = n->k, q = n->q;
    lanes *out = v->reg[i + 2];
    const lanes *u = v->reg[n->a >= 0 ? n->a : 0],
                *w = v->reg[n->b >= 0 ? n->b : 0];

#define EACH(made)                                                             \
    for (int p = 0; p < TAPE_SETS; p++)                                        \
        out[p] = made;                                                         \
    break
    switch (n->kind) {
        case STEP_LINEAR:
            tape_lanes_linear(v, &n->form, out);
            break;
        case STEP_SCALED:
            EACH(tape_lanes_scaled(v, i, p));
        case STEP_GROWTH:
        case STEP_APART:
            EACH(tape_lanes_grown(v, i, p, LANES_OF(0.0), LANES_OF(k)));
        case STEP_MIXED:
            EACH(tape_lanes_mixed(k, q, u[p]));
        case STEP_SINH:
            EACH(tape_lanes_sinh(k + u[p]));
        case STEP_FRICTION:
            EACH(tape_lanes_friction(k, q, u[p]));
        case STEP_PRODUCT:
            EACH(u[p] * w[p]);
        case STEP_QUOTIENT:
            EACH(u[p] / (k + w[p]));
        default:
            EACH(tape_lanes_function(v->t, i, u[p]));
    }
#undef EACH
}

/* ---- rates --------------------------------------------------------------- */

/* Before their exponentials are made. */
struct tape_lanes_rate {
    lanes mantissa[TAPE_SETS], exponent[TAPE_SETS];
};

/* By exponent k or, where a sinh tells them apart, k + 1. */
static inline void tape_lanes_rate_by(const struct tape_lanes *v,
                                      const struct real_tape_rate *r, int k,
                                      const lanes m[],
                                      struct tape_lanes_rate *out)
{
    const lanes none = LANES_OF(0.0);
    lanes own[TAPE_SETS];

    tape_lanes_linear(v, &r->exponent[k], out->exponent);
    for (int p = 0; p < TAPE_SETS; p++)
        out->mantissa[p] = r->kept[k] * m[p];
    if (r->sinh < 0)
        return;
    tape_lanes_linear(v, &r->exponent[k + 1], own);
    for (int p = 0; p < TAPE_SETS; p++) {
        const lanes w = v->reg[r->sinh][p];
        out->exponent[p] = lanes_less(w, none, own[p], out->exponent[p]);
        out->mantissa[p] =
            lanes_less(w, none, r->kept[k + 1] * m[p], out->mantissa[p]);
    }
}

/* 1 where the exponent is one with growths, real_tape_which; else 0. */
static inline lanes tape_lanes_near(const struct tape_lanes *v,
                                    const struct real_tape_form *u, int p)
{
    const struct real_tape *t = v->t;
    lanes near = LANES_OF(0.0);

    for (int j = u->first; j < u->first + u->terms; j++) {
        const int reg = t->term[j].reg;
        if (real_tape_takes(t, reg))
            near = lanes_less(LANES_OF(-1.0), v->reg[t->step[reg - 2].a][p],
                              LANES_OF(1.0), near);
    }
    return near;
}

static inline void tape_lanes_near_rate(const struct tape_lanes *v,
                                        const struct real_tape_rate *r,
                                        const lanes m[],
                                        struct tape_lanes_rate *out)
{
    const lanes none = LANES_OF(0.0);
    struct tape_lanes_rate near;

    tape_lanes_rate_by(v, r, TAPE_NEAR, m, &near);
    for (int p = 0; p < TAPE_SETS; p++) {
        lanes takes = tape_lanes_near(v, &r->exponent[TAPE_NEAR], p);
        if (r->sinh >= 0)
            takes = lanes_less(
                v->reg[r->sinh][p], none,
                tape_lanes_near(v, &r->exponent[TAPE_NEAR + 1], p), takes);
        out->exponent[p] =
            lanes_less(none, takes, near.exponent[p], out->exponent[p]);
        out->mantissa[p] =
            lanes_less(none, takes, near.mantissa[p], out->mantissa[p]);
    }
}

static inline void tape_lanes_rate(const struct tape_lanes *v, int rate,
                                   struct tape_lanes_rate *out)
{
    const struct real_tape_rate *r = &v->t->rate[rate];
    lanes m[TAPE_SETS];

    tape_lanes_linear(v, &r->mantissa, m);
    tape_lanes_rate_by(v, r, 0, m, out);
    if (r->grows)
        tape_lanes_near_rate(v, r, m, out);
    for (int p = 0; r->scaled >= 0 && p < TAPE_SETS; p++)
        out->exponent[p] += tape_lanes_scale(v, r->scaled - 2, p);
}

/* Both of the chart times exp(-scale). */
static inline void tape_lanes_field(const struct real_tape *t, const lanes x[],
                                    const lanes y[], lanes fx[], lanes fy[],
                                    lanes scale[])
{
    const lanes none = LANES_OF(0.0), one = LANES_OF(1.0);
    struct tape_lanes_rate rx, ry;
    struct tape_lanes v;

    v.t = t;
    for (int p = 0; p < TAPE_SETS; p++) {
        v.reg[0][p] = x[p];
        v.reg[1][p] = y[p];
    }
    for (int i = 0; i < t->rate_steps; i++)
        if (!t->step[i].idle)
            tape_lanes_step(&v, i);
    tape_lanes_rate(&v, 0, &rx);
    tape_lanes_rate(&v, 1, &ry);
    for (int p = 0; p < TAPE_SETS; p++) {
        const lanes ahead = rx.exponent[p] - ry.exponent[p];
        /* squared: a mantissa may be large */
        const lanes root = lanes_exp(-0.5 * lanes_size(ahead));
        const lanes of_x = lanes_less(ahead, none, root, one),
                    of_y = lanes_less(ahead, none, one, root);
        scale[p] = lanes_larger(rx.exponent[p], ry.exponent[p]);
        fx[p] = rx.mantissa[p] * of_x * of_x;
        fy[p] = ry.mantissa[p] * of_y * of_y;
    }
}
