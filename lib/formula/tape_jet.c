/* A tape along two curves: registers are Taylor series, one pair of
 * coefficients a call (core/jet.h).  Each step has series of its own at fixed
 * places of the workspace: first what it computes, then what helps it. */
#include <math.h>

#include "quad.h"
#include "tape_plane.h"

#define SCALAR double
#define FN(f)  f
#include "change.h"

enum { GROWTH_SERIES = 3, APART_SERIES = 5, RATE_SERIES = 4 };

struct course {
    const struct tape_plane *p;
    const struct real_tape *t;
    struct jet_work *w;
    size_t k;
    const jet_pair *x, *y;
};

/* An expression for each lane i. */
#define EACH(out, value)                                                       \
    do {                                                                       \
        for (int i = 0; i < JET_LANES; i++)                                    \
            (out)[i] = value;                                                  \
    } while (0)

/* ---- places -------------------------------------------------------------- */

static bool is_part(const struct real_tape *t, int reg, int *series)
{
    if (!real_tape_grows(t, reg))
        return false;
    *series =
        t->step[reg - 2].kind == STEP_GROWTH ? GROWTH_SERIES : APART_SERIES;
    return true;
}

static int series_of(const struct real_tape *t, const struct real_tape_entry *n)
{
    int all = 2, more;

    switch (n->kind) {
        case STEP_LINEAR:
        case STEP_PRODUCT:
            return 1;
        case STEP_EXP:
        case STEP_LN1P:
        case STEP_QUOTIENT:
            return 2;
        case STEP_GROWTH:
        case STEP_SINH:
            return 3;
        case STEP_APART:
        case STEP_MIXED:
        case STEP_FRICTION:
            return 5;
        case STEP_SCALED:
            for (int j = 0; j < n->form.terms; j++)
                if (is_part(t, t->term[n->form.first + j].reg, &more))
                    all += more;
            return all;
        default:
            return 4;
    }
}

bool tape_jet_slots(struct tape_plane *p)
{
    int used = 0;

    for (int i = 0; i < p->t.steps; i++) {
        p->slot[i] = (short) used;
        used += series_of(&p->t, &p->t.step[i]);
    }
    for (int i = 0; i < p->t.rates; i++) {
        p->rate_slot[i] = (short) used;
        used += RATE_SERIES;
    }
    return used <= JET_SLOTS;
}

static inline const jet_pair *series(const struct course *c, int reg)
{
    return reg == 0 ? c->x : reg == 1 ? c->y : c->w->slot[c->p->slot[reg - 2]];
}

/* Order 0 of all registers in a lane, which those of one step need. */
static double start(const struct course *c, int reg, int lane)
{
    return reg < 0 ? 0.0 : series(c, reg)[0][lane];
}

/* k u[k] beside the others */
static inline const jet_pair *derivative(size_t k, const jet_pair u[],
                                         jet_pair du[])
{
    du[k] = jet_number[k] * u[k];
    return du;
}

static jet_pair linear(const struct course *c, const struct real_tape_form *u)
{
    jet_pair sum = JET_PAIR(c->k == 0 ? u->constant : 0.0);

    for (int i = u->first; i < u->first + u->terms; i++)
        sum += c->t->term[i].c * series(c, c->t->term[i].reg)[c->k];
    return sum;
}

/* ---- exponentials -------------------------------------------------------- */

/* k (e^u - 1) e^-s; and with e = k e^u e^-s, e' = u' e */
static void growth(const struct course *c, int step, jet_pair s,
                   jet_pair own[][JET_SIZE])
{
    const struct real_tape_entry *n = &c->t->step[step];
    const jet_pair *u = series(c, n->a);
    const size_t k = c->k;
    jet_pair *e = own[1];
    const jet_pair *du = derivative(k, u, own[2]);

    if (k > 0) {
        own[0][k] = e[k] = jet_chain(c->w, k, u, du, e);
        return;
    }
    for (int i = 0; i < JET_LANES; i++) {
        const double grown =
            (n->b >= 0 ? start(c, n->b, i) : n->q + u[0][i]) - s[i];
        e[0][i] = exp(grown);
        own[0][0][i] =
            u[0][i] > 1
                ? e[0][i] - (s[i] > 0 ? exp(n->q - s[i]) : n->k)
                : (s[i] > 0 ? exp(n->q - s[i]) : n->k) * scalar_em1(u[0][i]);
    }
}

static void apart(const struct course *c, int step, jet_pair s,
                  jet_pair own[][JET_SIZE])
{
    const struct real_tape_entry *n = &c->t->step[step];
    const jet_pair *u = series(c, n->a), *w = series(c, n->b);
    const size_t k = c->k;
    jet_pair *eu = own[1], *ew = own[2];
    const jet_pair *du = derivative(k, u, own[3]),
                   *dw = derivative(k, w, own[4]);

    if (k > 0) {
        eu[k] = jet_chain(c->w, k, u, du, eu);
        ew[k] = jet_chain(c->w, k, w, dw, ew);
        own[0][k] = eu[k] - ew[k];
        return;
    }
    for (int i = 0; i < JET_LANES; i++) {
        const double a = u[0][i] - s[i], b = w[0][i] + n->q - s[i];
        own[0][0][i] = scalar_difference(n->k, a, b);
        eu[0][i] = scalar_exp(n->k, a);
        ew[0][i] = scalar_exp(n->k, b);
    }
}

static void exponential(const struct course *c, const struct real_tape_entry *n,
                        jet_pair own[][JET_SIZE])
{
    const jet_pair *u = series(c, n->a), *du = derivative(c->k, u, own[1]);

    if (c->k > 0)
        own[0][c->k] = jet_chain(c->w, c->k, u, du, own[0]);
    else
        EACH(own[0][0], exp(n->q + u[0][i]));
}

/* Largest exponents of both lanes, from order 0. */
static jet_pair scale_of(const struct course *c, int step)
{
    const struct real_tape_form *form = &c->t->step[step].form;
    jet_pair s = { 0 };

    for (int j = form->first; j < form->first + form->terms; j++) {
        const int reg = c->t->term[j].reg;
        if (!real_tape_grows(c->t, reg))
            continue;
        const struct real_tape_entry *n = &c->t->step[reg - 2];
        for (int i = 0; i < JET_LANES; i++) {
            const double u = start(c, n->a, i), w = start(c, n->b, i);
            s[i] = scalar_larger(s[i], n->kind == STEP_APART
                                           ? scalar_larger(u, w + n->q)
                                       : n->b >= 0 ? w
                                                   : n->q + u);
        }
    }
    return s;
}

/* own[1]: s and e^-s, then the parts. */
static void scaled(const struct course *c, int step, jet_pair own[][JET_SIZE])
{
    const struct real_tape_form *form = &c->t->step[step].form;
    const size_t k = c->k;
    int used = 2, series_used;

    if (k == 0) {
        own[1][0] = scale_of(c, step);
        EACH(own[1][1], exp(-own[1][0][i]));
    }
    const jet_pair less = own[1][1];
    jet_pair sum = k == 0 ? form->constant * less : JET_PAIR(0.0);
    for (int j = form->first; j < form->first + form->terms; j++) {
        const int reg = c->t->term[j].reg;
        const double factor = c->t->term[j].c;
        if (!is_part(c->t, reg, &series_used)) {
            sum += factor * (series(c, reg)[k] * less);
            continue;
        }
        if (c->t->step[reg - 2].kind == STEP_GROWTH)
            growth(c, reg - 2, own[1][0], &own[used]);
        else
            apart(c, reg - 2, own[1][0], &own[used]);
        sum += factor * own[used][k];
        used += series_used;
    }
    own[0][k] = sum;
}

/* ---- logarithms ---------------------------------------------------------- */

/* w' = p u' with the logistic p, p' = (1 - p) w' */
static void mixed(const struct course *c, const struct real_tape_entry *n,
                  jet_pair own[][JET_SIZE])
{
    const jet_pair *u = series(c, n->a);
    const size_t k = c->k;
    jet_pair *out = own[0], *p = own[1], *rest = own[2];
    const jet_pair *du = derivative(k, u, own[3]);

    if (k == 0) {
        EACH(out[0], scalar_log1p_expm1(n->k, n->q, u[0][i]));
        EACH(p[0], scalar_logistic(n->k, n->q, u[0][i]));
        EACH(rest[0], scalar_logistic_rest(n->k, n->q, u[0][i]));
    } else {
        out[k] = jet_chain(c->w, k, u, du, p);
    }
    const jet_pair *dw = derivative(k, out, own[4]);
    if (k > 0) {
        p[k] = jet_chain(c->w, k, out, dw, rest);
        rest[k] = -p[k];
    }
}

/* (d w') = u': coefficient k of w, d[0] apart and dw = j w[j] */
static inline jet_pair over_slope(size_t k, const jet_pair u[],
                                  const jet_pair dw[], const jet_pair d[],
                                  jet_pair d0)
{
    return (u[k] - jet_sum(k - 1, dw + 1, d + k - 1) * jet_inverse[k]) / d0;
}

/* (k + u) w' = u' */
static void ln1p(const struct course *c, const struct real_tape_entry *n,
                 jet_pair own[][JET_SIZE])
{
    const jet_pair *u = series(c, n->a);
    const size_t k = c->k;

    if (k == 0)
        EACH(own[0][0], log1p(u[0][i] / n->k));
    else
        own[0][k] = over_slope(k, u, own[1], u, n->k + u[0]);
    derivative(k, own[0], own[1]);
}

/* ---- hyperbolic and circular functions ----------------------------------- */

/* e^-|w0| sinh w, w = k + u: s' = c u', c' = s u' */
static void sinh_frozen(const struct course *c, const struct real_tape_entry *n,
                        jet_pair own[][JET_SIZE])
{
    const jet_pair *u = series(c, n->a);
    const size_t k = c->k;
    const jet_pair *du = derivative(k, u, own[2]);

    if (k > 0) {
        own[0][k] = jet_chain(c->w, k, u, du, own[1]);
        own[1][k] = jet_chain(c->w, k, u, du, own[0]);
        return;
    }
    EACH(own[0][0], scalar_sinh(n->k + u[0][i]));
    EACH(own[1][0], scalar_cosh(n->k + u[0][i]));
}

/* e^-|w| sinh w: its slope e^(-2 |w|) = e, e' = -2 sign(w) e w' */
static void sinh_joined(const struct course *c, const struct real_tape_entry *n,
                        jet_pair own[][JET_SIZE])
{
    const jet_pair *u = series(c, n->a);
    const size_t k = c->k;
    const jet_pair *du = derivative(k, u, own[2]);

    if (k == 0) {
        EACH(own[0][0], scalar_sinh(n->k + u[0][i]));
        EACH(own[1][0], exp(-2 * fabs(n->k + u[0][i])));
        return;
    }
    own[0][k] = jet_chain(c->w, k, u, du, own[1]);
    own[1][k] =
        2.0 * jet_choose(own[0][0] < JET_PAIR(0.0), own[0][k], -own[0][k]);
}

/* m = asinh(e^w/2): m' = t w', t = tanh m, t' = b m', b = 1 - t^2 */
static void friction(const struct course *c, const struct real_tape_entry *n,
                     jet_pair own[][JET_SIZE])
{
    const jet_pair *u = series(c, n->a);
    const size_t k = c->k;
    jet_pair *m = own[0], *t = own[1], *b = own[2];
    const jet_pair *du = derivative(k, u, own[3]);

    if (k == 0) {
        EACH(m[0], scalar_friction(n->k, n->q, u[0][i]));
        EACH(b[0], scalar_friction_bend(n->k + u[0][i]));
        EACH(t[0], scalar_friction_slope(n->k + u[0][i]));
    } else {
        m[k] = jet_chain(c->w, k, u, du, t);
    }
    const jet_pair *dm = derivative(k, m, own[4]);
    if (k > 0) {
        t[k] = jet_chain(c->w, k, m, dm, b);
        b[k] = -jet_square(k, t);
    }
}

/* g' = h u', h' = sign g u' */
static void turning(const struct course *c, const struct real_tape_entry *n,
                    jet_pair own[][JET_SIZE])
{
    const jet_pair *u = series(c, n->a);
    const size_t k = c->k;
    const bool circular = n->kind == STEP_SIN;
    jet_pair *g = own[1], *h = own[2];
    const jet_pair *du = derivative(k, u, own[3]);

    if (k > 0) {
        own[0][k] = g[k] = jet_chain(c->w, k, u, du, h);
        const jet_pair slope = jet_chain(c->w, k, u, du, g);
        h[k] = circular ? -slope : slope;
    } else if (circular) {
        EACH(own[0][0], change_sin(n->k, n->q, u[0][i]));
        EACH(h[0], change_sin_slope(n->k, n->q, u[0][i]));
        g[0] = n->k + own[0][0];
    } else {
        EACH(own[0][0], change_cosh(n->k, u[0][i]));
        EACH(h[0], sinh(n->k + u[0][i]));
        EACH(g[0], cosh(n->k + u[0][i]));
    }
}

/* t' = b u' with b = 1 + t^2 for tan, 1 - t^2 for tanh */
static void tangent(const struct course *c, const struct real_tape_entry *n,
                    jet_pair own[][JET_SIZE])
{
    const jet_pair *u = series(c, n->a);
    const size_t k = c->k;
    const bool circular = n->kind == STEP_TAN;
    jet_pair *t = own[1], *b = own[2];
    const jet_pair *du = derivative(k, u, own[3]);

    if (k > 0) {
        own[0][k] = t[k] = jet_chain(c->w, k, u, du, b);
        b[k] = circular ? jet_square(k, t) : -jet_square(k, t);
    } else if (circular) {
        EACH(own[0][0], change_tan(n->k, n->q, u[0][i]));
        EACH(t[0], change_tangent(n->k, n->q, u[0][i]));
        b[0] = 1 + t[0] * t[0];
    } else {
        EACH(own[0][0], change_tanh(n->k, u[0][i]));
        EACH(t[0], tanh(n->k + u[0][i]));
        EACH(b[0], change_tanh_slope(n->k + u[0][i]));
    }
}

/* d m' = u', w = k + u: d = 1 + w^2 for atan; d' = -w m' for asin, w m' for
 * asinh */
static void inverse(const struct course *c, const struct real_tape_entry *n,
                    jet_pair own[][JET_SIZE])
{
    const jet_pair *u = series(c, n->a);
    const size_t k = c->k;
    jet_pair *m = own[0], *w = own[1], *d = own[2], *dm = own[3];

    w[k] = k == 0 ? n->k + u[0] : u[k];
    if (k > 0)
        m[k] = over_slope(k, u, dm, d, d[0]);
    else if (n->kind == STEP_ATAN)
        EACH(m[0], change_atan(n->k, u[0][i]));
    else if (n->kind == STEP_ASIN)
        EACH(m[0], change_asin(n->k, u[0][i]));
    else
        EACH(m[0], change_asinh(n->k, u[0][i]));
    derivative(k, m, dm);
    if (n->kind == STEP_ATAN)
        d[k] = (k == 0 ? JET_PAIR(1.0) : JET_PAIR(0.0)) + jet_square(k, w);
    else if (k == 0 && n->kind == STEP_ASIN)
        EACH(d[0], change_root(w[0][i]));
    else if (k == 0)
        EACH(d[0], change_length(w[0][i]));
    else
        d[k] = n->kind == STEP_ASIN ? -jet_chain(c->w, k, m, dm, w)
                                    : jet_chain(c->w, k, m, dm, w);
}

/* ---- steps --------------------------------------------------------------- */

/* u/(k + w), the divisor in own[1] */
static void quotient(const struct course *c, const struct real_tape_entry *n,
                     jet_pair own[][JET_SIZE])
{
    const jet_pair *u = series(c, n->a), *w = series(c, n->b);
    const size_t k = c->k;

    own[1][k] = k == 0 ? n->k + w[0] : w[k];
    own[0][k] = jet_quotient(k, u, own[1], own[0]);
}

static bool is_joined(const struct real_tape *t, int reg)
{
    bool joined = false;

    for (int i = 0; i < t->rates; i++)
        joined = joined || (t->rate[i].sinh == reg && t->rate[i].joined);
    return joined;
}

static void step_at(const struct course *c, int i)
{
    const struct real_tape_entry *n = &c->t->step[i];
    jet_pair(*own)[JET_SIZE] = &c->w->slot[c->p->slot[i]];
    const jet_pair none = { 0 };

    switch (n->kind) {
        case STEP_LINEAR:
            own[0][c->k] = linear(c, &n->form);
            break;
        case STEP_GROWTH:
            growth(c, i, none, own);
            break;
        case STEP_APART:
            apart(c, i, none, own);
            break;
        case STEP_EXP:
            exponential(c, n, own);
            break;
        case STEP_MIXED:
            mixed(c, n, own);
            break;
        case STEP_LN1P:
            ln1p(c, n, own);
            break;
        case STEP_SINH:
            (is_joined(c->t, i + 2) ? sinh_joined : sinh_frozen)(c, n, own);
            break;
        case STEP_FRICTION:
            friction(c, n, own);
            break;
        case STEP_SIN:
        case STEP_COSH:
            turning(c, n, own);
            break;
        case STEP_TAN:
        case STEP_TANH:
            tangent(c, n, own);
            break;
        case STEP_PRODUCT:
            own[0][c->k] = jet_product(c->k, series(c, n->a), series(c, n->b));
            break;
        case STEP_QUOTIENT:
            quotient(c, n, own);
            break;
        case STEP_SCALED:
            scaled(c, i, own);
            break;
        default:
            inverse(c, n, own);
            break;
    }
}

/* ---- rates --------------------------------------------------------------- */

/* What the exponent has besides its linear form, at order 0: s, |w0| of the
 * factor sinh w where that is frozen. */
static jet_pair fixed(const struct course *c, const struct real_tape_rate *r)
{
    jet_pair s = { 0 };

    if (r->scaled >= 0)
        s = c->w->slot[c->p->slot[r->scaled - 2] + 1][0];
    if (r->sinh >= 0 && !is_joined(c->t, r->sinh)) {
        const struct real_tape_entry *n = &c->t->step[r->sinh - 2];
        EACH(s, fabs(n->k + start(c, n->a, i)));
    }
    return s;
}

/* The linear form of a rate's exponent, and what rounding took from it. */
static jet_pair exponent(const struct course *c, const struct real_tape_rate *r,
                         jet_pair *kept)
{
    if (r->sinh < 0) {
        *kept = JET_PAIR(r->kept[0]);
        return linear(c, &r->exponent[0]);
    }
    if (!is_joined(c->t, r->sinh)) {
        *kept = JET_PAIR(r->mean_kept);
        return linear(c, &r->mean);
    }
    const jet_mask less = series(c, r->sinh)[0] < JET_PAIR(0.0);
    *kept = jet_choose(less, JET_PAIR(r->kept[1]), JET_PAIR(r->kept[0]));
    return jet_choose(less, linear(c, &r->exponent[1]),
                      linear(c, &r->exponent[0]));
}

static bool is_fixed(const struct real_tape_rate *r)
{
    return r->exponent[0].terms == 0 && r->exponent[1].terms == 0;
}

/* Mantissa, exponent E, its derivative and kept e^(E - scale): four series.
 * Order 0 of the last is put in by `begin`. */
static void begin(const struct course *c, int rate, jet_pair scale)
{
    const struct real_tape_rate *r = &c->t->rate[rate];
    jet_pair(*own)[JET_SIZE] = &c->w->slot[c->p->rate_slot[rate]];
    jet_pair kept;

    own[1][0] = exponent(c, r, &kept);
    const jet_pair e = own[1][0] + fixed(c, r) - scale;
    EACH(own[3][0], kept[i] * exp(e[i]));
}

static jet_pair rate_at(const struct course *c, int i)
{
    const struct real_tape_rate *r = &c->t->rate[i];
    jet_pair(*own)[JET_SIZE] = &c->w->slot[c->p->rate_slot[i]];
    const size_t k = c->k;
    jet_pair kept;

    own[0][k] = linear(c, &r->mantissa);
    if (is_fixed(r))
        return own[0][k] * own[3][0];
    if (k > 0)
        own[1][k] = exponent(c, r, &kept);
    const jet_pair *du = derivative(k, own[1], own[2]);
    if (k > 0)
        own[3][k] = jet_chain(c->w, k, own[1], du, own[3]);
    return r->mantissa.terms ? jet_product(k, own[0], own[3])
                             : r->mantissa.constant * own[3][k];
}

static jet_pair size_of(const struct course *c, int i)
{
    jet_pair kept;

    return exponent(c, &c->t->rate[i], &kept) + fixed(c, &c->t->rate[i]);
}

void tape_jet(const void *ctx, struct jet_work *w, size_t k, const jet_pair x[],
              const jet_pair y[], jet_pair fx[], jet_pair fy[])
{
    const struct tape_plane *p = ctx;
    const struct course c = { p, &p->t, w, k, x, y };

    for (int i = 0; i < p->t.rate_steps; i++)
        step_at(&c, i);
    if (k == 0) {
        const jet_pair e[2] = { size_of(&c, 0), size_of(&c, 1) };
        EACH(w->log_scale, scalar_larger(e[0][i], e[1][i]));
        begin(&c, 0, w->log_scale);
        begin(&c, 1, w->log_scale);
    }
    fx[k] = rate_at(&c, 0);
    fy[k] = rate_at(&c, 1);
}

void tape_jet_rate(const void *ctx, size_t which, struct jet_work *w, size_t k,
                   const jet_pair x[], const jet_pair y[], jet_pair rate[])
{
    const struct tape_plane *p = ctx;
    const struct course c = { p, &p->t, w, k, x, y };
    const int i = 2 + (int) which;

    for (int j = p->t.rate_steps; j < p->t.steps; j++)
        step_at(&c, j);
    if (k == 0)
        begin(&c, i, w->log_scale);
    rate[k] = rate_at(&c, i);
}
