/*
 * tape_each.h -- inside tape_jet.c, of JET_MANY lanes: tape_run.c and the rates
 * of tape_plane.c over points side by side, each of its own plane, to the same
 * bits.  The planes are alike: only their numbers differ.  A lane that meets
 * what is rare, as a number beyond e^+-700, is odd: the plain functions make
 * it.
 */
#pragma once

#include "elementary_lanes.h"
#include "tape_course.h"

enum each_making { EACH_VALUES, EACH_GRADIENTS, EACH_SERIES };

struct each_slope {
    jet_pair x, y;
};

struct each {
    const struct tape_plane *p[JET_LANES];
    bool same;            /* one plane */
    jet_pair *reg, *keep; /* keep: of series */
    struct each_slope *g; /* gradients */
    jet_mask odd;
};

/* reg, keep and g are the caller's to set. */
static inline void each_begin(struct each *e, const void *const ctx[])
{
    *e = (struct each){ .same = true };
    for (int l = 0; l < JET_LANES; l++) {
        e->p[l] = ctx[l];
        e->same = e->same && ctx[l] == ctx[0];
    }
}

/* Which of a tape's steps have lanes. */
static inline bool each_has(enum step_kind kind)
{
    return kind == STEP_LINEAR || kind == STEP_GROWTH || kind == STEP_APART ||
           kind == STEP_MIXED || kind == STEP_SINH || kind == STEP_FRICTION ||
           kind == STEP_PRODUCT || kind == STEP_QUOTIENT || kind == STEP_SCALED;
}

static inline bool each_can(const struct real_tape *t)
{
    bool can = true;

    for (int i = 0; i < t->steps; i++)
        can = can && each_has(t->step[i].kind);
    return can;
}

/* A number of the first plane in all of them. */
static inline jet_pair each_number(const struct each *e, const double *x)
{
    const ptrdiff_t place = (const char *) x - (const char *) e->p[0];

    if (e->same)
        return JET_PAIR(*x);
#define NUMBER(l)                                                              \
    *(const double *) (const void *) ((const char *) e->p[l] + place)
    return JET_EACH(NUMBER);
#undef NUMBER
}

/* What exponentials take. */
#define EACH_FAR 690.0

/* Beyond that, or no number. */
static inline void each_watch(struct each *e, jet_pair exponent)
{
    e->odd |= ~(each_size(exponent) < EACH_FAR);
}

/* ---- linear forms -------------------------------------------------------- */

static inline jet_pair each_linear(const struct each *e,
                                   const struct real_tape_form *u)
{
    const struct real_tape_term *term = &e->p[0]->t.term[u->first];
    jet_pair sum = each_number(e, &u->constant);

    for (int j = 0; j < u->terms; j++)
        sum += each_number(e, &term[j].c) * e->reg[term[j].reg];
    return sum;
}

static inline void each_add(jet_pair c, const struct each_slope *u,
                            struct each_slope *sum)
{
    sum->x += c * u->x;
    sum->y += c * u->y;
}

static inline struct each_slope each_linear_slope(
    const struct each *e, const struct real_tape_form *u)
{
    const struct real_tape_term *term = &e->p[0]->t.term[u->first];
    struct each_slope sum = { JET_PAIR(0.0), JET_PAIR(0.0) };

    for (int j = 0; j < u->terms; j++)
        each_add(each_number(e, &term[j].c), &e->g[term[j].reg], &sum);
    return sum;
}

/* ---- steps --------------------------------------------------------------- */

/* A register and its slopes in those that it is made of. */
struct each_made {
    jet_pair out, by_a, by_b;
};

static inline struct each_made each_growth(struct each *e, jet_pair p,
                                           jet_pair l, jet_pair u,
                                           jet_pair keep[])
{
    const jet_mask large = (u > 1.0) | ~(p > 0.0);
    jet_pair power = JET_PAIR(0.0), out = JET_PAIR(0.0);

    if (each_any(large)) {
        const jet_pair of = jet_choose(large, l, JET_PAIR(0.0));
        each_watch(e, of);
        power = each_exp(of);
        out = power - p;
    }
    if (each_any(~large)) {
        const jet_pair of = jet_choose(large, JET_PAIR(0.0), u);
        jet_pair grown;
        each_watch(e, of);
        const jet_pair more = each_less_one(of, &grown);
        power = jet_choose(large, power, p * grown);
        out = jet_choose(large, out, p * more);
    }
    keep[0] = power;
    return (struct each_made){ out, power, JET_PAIR(0.0) };
}

static inline struct each_made each_apart(struct each *e, jet_pair p,
                                          jet_pair u, jet_pair w,
                                          jet_pair keep[])
{
    const jet_mask up = u > w;
    const jet_pair large = jet_choose(up, u, w), half = each_exp(large / 2.0);
    const jet_pair most = p * half * half;
    const jet_pair down = jet_choose(up, w - u, u - w);
    jet_pair power;
    const jet_pair less = each_less_one(down, &power), rest = most * power;

    each_watch(e, large / 2.0);
    each_watch(e, down);
    keep[0] = jet_choose(up, most, rest);
    keep[1] = jet_choose(up, rest, most);
    return (struct each_made){ jet_choose(up, -most * less, most * less),
                               keep[0], -keep[1] };
}

/* Growths and aparts times e^-s. */
static inline struct each_made each_grown(struct each *e,
                                          const struct real_tape_entry *n,
                                          jet_pair s, jet_pair keep[])
{
    const jet_pair q = each_number(e, &n->q), u = e->reg[n->a];
    jet_pair k = each_number(e, &n->k);

    if (n->kind == STEP_APART)
        return each_apart(e, k, u - s, e->reg[n->b] + q - s, keep);
    if (each_any(s > 0.0)) {
        each_watch(e, q - s);
        k = jet_choose((s > 0.0) & (k > 0.0), each_exp(q - s), k);
    }
    return each_growth(e, k, (n->b >= 0 ? e->reg[n->b] : q + u) - s, u, keep);
}

static inline struct each_made each_mixed(struct each *e, jet_pair r,
                                          jet_pair s, jet_pair u,
                                          jet_pair keep[])
{
    jet_pair power;
    const jet_pair change = r * each_less_one(u, &power), sum = r * power + s;
    const jet_mask near = 2.0 * change > -1.0;

    each_watch(e, u);
    e->odd |= ~((s < 0.0) | (s > 0.0)) | ~(sum > 1e-300) | ~(sum < 1e300);
    keep[0] = r * power / sum;
    keep[1] = s / sum;
    return (struct each_made){ each_ln(near, jet_choose(near, change, sum)),
                               keep[0], JET_PAIR(0.0) };
}

static inline struct each_made each_sinh(struct each *e, jet_pair w,
                                         bool joined, jet_pair keep[])
{
    jet_pair power;
    const jet_pair twice = -2.0 * each_size(w),
                   less = each_less_one(twice, &power);

    each_watch(e, twice);
    keep[0] = each_signed(-less / 2.0, w);
    keep[1] = joined ? power : (1.0 + power) / 2.0;
    return (struct each_made){ keep[0], keep[1], JET_PAIR(0.0) };
}

static inline jet_pair each_ln1p(jet_pair x)
{
    const jet_mask little = each_size(x) < 1e-5;
    const jet_pair series = x - x * x * (1.0 / 2 - x * (1.0 / 3 - x / 4.0));

    if (!each_any(~little))
        return series;
    return jet_choose(little, series, each_ln(each_all(), x));
}

/* kept_friction where e^-u does not overflow, w and k > 0.7. */
static inline jet_pair each_fair_friction(struct each *e, jet_pair q,
                                          jet_pair u, jet_pair keep[])
{
    jet_pair power;
    const jet_pair change = q * each_less_one(-2.0 * u, &power);
    const jet_pair sum = 1.0 + q * power, s = each_root(sum),
                   s0 = each_root(1.0 + q);
    const jet_pair part = change / ((s + s0) * (1.0 + s0));

    e->odd |= ~(part > -0.9) | ~(part < 1e300);
    keep[0] = 1.0 / s;
    keep[1] = q * power / sum;
    return u + each_ln1p(part);
}

/* The same where w < 1 < k, and |u| >= 1. */
static inline jet_pair each_slight_friction(jet_pair k, jet_pair w,
                                            jet_pair keep[])
{
    const jet_mask up = w > 0.0;
    const jet_pair power = each_exp(-2.0 * each_size(w)), e = each_exp(w);
    const jet_pair sum = jet_choose(up, 1.0 + 4.0 * power, 4.0 + power);
    const jet_pair root = each_root(sum), t = e / 2.0, square = t * t;
    const jet_pair far = 4.0 * each_exp(-2.0 * k);

    keep[0] = jet_choose(up, 1.0 / root, e / root);
    keep[1] = jet_choose(up, 4.0 * power / sum, 4.0 / sum);
    return each_log1p(t + square / (1.0 + each_root(1.0 + square))) -
           (k + each_log1p((each_root(1.0 + far) - 1.0) / 2.0));
}

static inline struct each_made each_friction(struct each *e, jet_pair k,
                                             jet_pair q, jet_pair u,
                                             jet_pair keep[])
{
    const jet_pair w = k + u, none = JET_PAIR(0.0);
    const jet_mask fair = (k > 0.7) & (w > 0.7) & (u > -300.0) & (u < 300.0);
    const jet_mask slight = ~(w > 0.7) & (w > -340.0) & (k > 1.0) &
                            (k < 300.0) & (each_size(u) >= 1.0);
    jet_pair out = none, less[2];

    e->odd |= ~(fair | slight);
    if (each_any(fair))
        out = each_fair_friction(e, q, jet_choose(fair, u, none), keep);
    if (each_any(slight)) {
        const jet_pair of = jet_choose(slight, w, none);
        out = jet_choose(fair, out, each_slight_friction(k, of, less));
        keep[0] = jet_choose(fair, keep[0], less[0]);
        keep[1] = jet_choose(fair, keep[1], less[1]);
    }
    return (struct each_made){ out, keep[0], JET_PAIR(0.0) };
}

static inline struct each_made each_plain(struct each *e,
                                          const struct real_tape_entry *n,
                                          bool frozen, jet_pair keep[])
{
    const jet_pair k = each_number(e, &n->k), u = e->reg[n->a];

    switch (n->kind) {
        case STEP_MIXED:
            return each_mixed(e, k, each_number(e, &n->q), u, keep);
        case STEP_SINH:
            return each_sinh(e, k + u, !frozen || n->joined, keep);
        case STEP_FRICTION:
            return each_friction(e, k, each_number(e, &n->q), u, keep);
        case STEP_PRODUCT:
            keep[0] = u;
            keep[1] = e->reg[n->b];
            return (struct each_made){ u * keep[1], keep[1], u };
        default: /* STEP_QUOTIENT */
            keep[1] = 1.0 / (k + e->reg[n->b]);
            keep[0] = u / (k + e->reg[n->b]);
            return (struct each_made){ keep[0], keep[1], -keep[0] * keep[1] };
    }
}

static inline struct each_slope each_gradient(const struct each *e,
                                              const struct real_tape_entry *n,
                                              const struct each_made *made)
{
    struct each_slope sum = { made->by_a * e->g[n->a].x,
                              made->by_a * e->g[n->a].y };

    if (n->b >= 0 && n->kind != STEP_GROWTH)
        each_add(made->by_b, &e->g[n->b], &sum);
    return sum;
}

/* The s of a scaled step. */
static inline jet_pair each_scale(const struct each *e, int i)
{
    const struct real_tape *t = &e->p[0]->t;
    const struct real_tape_form *f = &t->step[i].form;
    jet_pair s = JET_PAIR(0.0);

    for (int j = f->first; j < f->first + f->terms; j++) {
        const int reg = t->term[j].reg;
        if (!real_tape_grows(t, reg))
            continue;
        const struct real_tape_entry *n = &t->step[reg - 2];
        const jet_pair u = e->reg[n->a], q = each_number(e, &n->q);
        jet_pair most = n->b >= 0 ? e->reg[n->b] : q + u;
        if (n->kind == STEP_APART)
            most = jet_choose(u > most + q, u, most + q);
        s = jet_choose(s > most, s, most);
    }
    return s;
}

static inline void each_scaled(struct each *e, enum each_making m, int i,
                               jet_pair keep[])
{
    const struct real_tape *t = &e->p[0]->t;
    const struct real_tape_form *f = &t->step[i].form;
    const jet_pair s = each_scale(e, i);
    jet_pair less = JET_PAIR(1.0);
    struct each_slope slope = { JET_PAIR(0.0), JET_PAIR(0.0) };
    int at = 1;

    if (each_any(s > 0.0)) {
        each_watch(e, s);
        less = jet_choose(s > 0.0, each_exp(-s), less);
    }
    jet_pair sum = each_number(e, &f->constant) * less;
    keep[0] = less;
    for (int j = f->first; j < f->first + f->terms; j++) {
        const int reg = t->term[j].reg;
        const jet_pair c = each_number(e, &t->term[j].c);
        if (real_tape_grows(t, reg)) {
            const struct real_tape_entry *part = &t->step[reg - 2];
            const struct each_made made = each_grown(e, part, s, keep + at);
            sum += c * made.out;
            at += m == EACH_SERIES ? tape_kind_slots(part->kind) : 0;
            if (m == EACH_GRADIENTS) {
                const struct each_slope own = each_gradient(e, part, &made);
                each_add(c, &own, &slope);
            }
        } else {
            sum += c * (e->reg[reg] * less);
            if (m == EACH_GRADIENTS)
                each_add(c * less, &e->g[reg], &slope);
        }
    }
    e->reg[i + 2] = sum;
    if (m == EACH_GRADIENTS)
        e->g[i + 2] = slope;
}

/* Steps from .. to that `used` has (NULL: all that somebody reads). */
static inline __attribute__((always_inline)) void each_run(struct each *e,
                                                           enum each_making m,
                                                           const bool *used,
                                                           int from, int to)
{
    const struct real_tape *t = &e->p[0]->t;
    jet_pair own[TAPE_KEPT + 1];

    for (int i = from; i < to; i++) {
        const struct real_tape_entry *n = &t->step[i];
        jet_pair *keep = m == EACH_SERIES ? e->keep + e->p[0]->kept[i] : own;
        if (used ? !used[i] : n->idle)
            continue;
        if (n->kind == STEP_LINEAR) {
            e->reg[i + 2] = each_linear(e, &n->form);
            if (m == EACH_GRADIENTS)
                e->g[i + 2] = each_linear_slope(e, &n->form);
        } else if (n->kind == STEP_SCALED) {
            each_scaled(e, m, i, keep);
        } else {
            const struct each_made made =
                n->kind == STEP_GROWTH || n->kind == STEP_APART
                    ? each_grown(e, n, JET_PAIR(0.0), keep)
                    : each_plain(e, n, m == EACH_SERIES, keep);
            e->reg[i + 2] = made.out;
            if (m == EACH_GRADIENTS)
                e->g[i + 2] = each_gradient(e, n, &made);
        }
    }
}

/* ---- rates --------------------------------------------------------------- */

/* A rate before its exponential is made. */
struct each_rate {
    jet_pair kept, linear, mantissa; /* the last the product of the others */
    jet_pair exponent;
    struct each_slope along; /* the exponent's gradient */
};

/* Where exponent `less`, with growths, is the one: tape_which. */
static inline jet_mask each_near(const struct each *e,
                                 const struct real_tape_rate *r, int less)
{
    const struct real_tape *t = &e->p[0]->t;
    const struct real_tape_form *u = &r->exponent[less + TAPE_NEAR];
    jet_mask near = ~each_all();

    for (int j = u->first; r->grows && j < u->first + u->terms; j++) {
        const int g = t->term[j].reg - 2;
        if (g >= 0 && t->step[g].kind == STEP_GROWTH)
            near |= (e->reg[t->step[g].a] > -1.0) &
                    (each_number(e, &t->step[g].k) > 0.0);
    }
    return near;
}

/* Exponent k in the lanes of a mask. */
static inline void each_take(const struct each *e, enum each_making m,
                             const struct real_tape_rate *r, int k,
                             jet_mask mask, struct each_rate *out)
{
    if (!each_any(mask))
        return;
    out->kept = jet_choose(mask, each_number(e, &r->kept[k]), out->kept);
    out->exponent =
        jet_choose(mask, each_linear(e, &r->exponent[k]), out->exponent);
    if (m != EACH_GRADIENTS)
        return;
    const struct each_slope along = each_linear_slope(e, &r->exponent[k]);
    out->along.x = jet_choose(mask, along.x, out->along.x);
    out->along.y = jet_choose(mask, along.y, out->along.y);
}

static inline struct each_rate each_rate(const struct each *e,
                                         enum each_making m, int rate)
{
    const struct real_tape_rate *r = &e->p[0]->t.rate[rate];
    const jet_mask none = ~each_all();
    struct each_rate out = { .kept = JET_PAIR(0.0) };

    for (int less = 0; less < (r->sinh >= 0 ? 2 : 1); less++) {
        const jet_mask under = r->sinh >= 0 ? e->reg[r->sinh] < 0.0 : none;
        const jet_mask here = less ? under : ~under;
        const jet_mask near = here & each_near(e, r, less);
        each_take(e, m, r, less, here & ~near, &out);
        each_take(e, m, r, less + TAPE_NEAR, near, &out);
    }
    if (r->scaled >= 0)
        out.exponent += each_scale(e, r->scaled - 2);
    else
        out.exponent += 0.0;
    out.linear = each_linear(e, &r->mantissa);
    out.mantissa = out.kept * out.linear;
    return out;
}

/* M' e^E + M E' e^E, `power` e^E. */
static inline struct each_slope each_rate_slope(const struct each *e, int rate,
                                                const struct each_rate *r,
                                                jet_pair power)
{
    const struct each_slope up =
        each_linear_slope(e, &e->p[0]->t.rate[rate].mantissa);
    const jet_pair rise = r->kept * power, way = r->mantissa * power;

    return (struct each_slope){ rise * up.x + way * r->along.x,
                                rise * up.y + way * r->along.y };
}
