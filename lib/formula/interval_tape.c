/* A step at a time, each by the recurrence of tape_jet.c with intervals in
 * place of numbers: for w = f(u), k w_k is the convolution of j u_j with
 * f'(u), of which f'(u) at order 0 and its own derivative are known. */
#include "interval_tape.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "interval_math.h"

enum { REGISTERS = TAPE_STEPS + 2, KEPT = 2 };

static struct interval point(double x)
{
    return interval_point(x);
}

/* ---- what is needed ------------------------------------------------------ */

static void need_linear(const struct linear *u, bool needed[])
{
    for (int i = 0; i < u->terms; i++)
        needed[u->term[i].reg] = true;
}

static void need_rate(const struct tape_rate *r, bool needed[])
{
    need_linear(&r->mantissa, needed);
    for (int k = 0; k < TAPE_EXPONENTS; k++)
        need_linear(&r->exponent[k], needed);
    if (r->sinh >= 0)
        needed[r->sinh] = true;
    if (r->scaled >= 0)
        needed[r->scaled] = true;
}

/* Those of whatever is needed; growths are made where they are needed. */
static void need_parts(const struct tape *t, bool needed[])
{
    for (int i = t->steps; i-- > 0;) {
        const struct step *s = &t->step[i];
        if (!needed[i + 2])
            continue;
        if (s->a >= 0)
            needed[s->a] = true;
        if (s->b >= 0)
            needed[s->b] = true;
        if (s->kind == STEP_LINEAR || s->kind == STEP_SCALED)
            need_linear(&s->form, needed);
    }
}

static bool has_rule(enum step_kind kind)
{
    static const enum step_kind known[] = {
        STEP_LINEAR,   STEP_GROWTH, STEP_APART,    STEP_EXP,
        STEP_MIXED,    STEP_SINH,   STEP_FRICTION, STEP_PRODUCT,
        STEP_QUOTIENT, STEP_SCALED, STEP_LN1P
    };

    for (size_t i = 0; i < sizeof known / sizeof *known; i++)
        if (known[i] == kind)
            return true;
    return false;
}

/* The nearest whole number to a constant, and e^(what is left). */
static void split(const struct interval_graph *g, int node, double *whole,
                  struct interval *part)
{
    mpfi_srcptr c = interval_graph_value(g, node);
    mpfi_t rest;

    mpfi_init2(rest, mpfi_get_prec(c));
    *whole = rint(mpfi_get_d(c));
    mpfi_sub_d(rest, c, *whole);
    mpfi_exp(rest, rest);
    *part = interval_of_mpfi(rest);
    mpfi_clear(rest);
}

enum status interval_tape_init(struct interval_tape *out, const struct tape *t,
                               const struct interval_graph *g, const int rate[],
                               int rates, struct fault *why)
{
    bool needed[REGISTERS] = { false };

    *out = (struct interval_tape){ .t = t, .rate = { 0, 1 }, .rates = 2 };
    for (int i = 0; i < rates; i++)
        out->rate[out->rates++] = rate[i];
    for (int i = 0; i < out->rates; i++)
        need_rate(&t->rate[out->rate[i]], needed);
    need_linear(&t->value[0], needed);
    need_parts(t, needed);
    for (int i = 0; i < t->steps; i++) {
        out->used[i] = needed[i + 2];
        if (needed[i + 2] && !has_rule(t->step[i].kind)) {
            snprintf(why->text, sizeof why->text,
                     "a function in the law's formulas has no rule for proofs");
            return STATUS_BAD_ARGUMENT;
        }
    }
    for (int i = 0; i < g->nodes; i++)
        out->constant[g->node[i]] = interval_graph_get(g, g->node[i]);
    for (int i = 0; i < out->rates; i++)
        for (int k = 0; k < TAPE_EXPONENTS; k++)
            split(g, t->rate[out->rate[i]].exponent[k].constant,
                  &out->whole[i][k], &out->part[i][k]);
    out->series = malloc((REGISTERS + KEPT) * sizeof *out->series);
    return out->series ? STATUS_OK : STATUS_NO_MEMORY;
}

void interval_tape_free(struct interval_tape *t)
{
    free(t->series);
    t->series = NULL;
}

/* ---- series -------------------------------------------------------------- */

struct run {
    const struct interval_tape *t;
    size_t n;
    struct interval_series *reg, *keep;
    double sign[REGISTERS];  /* of a sinh's argument, as it is taken */
    double scale[REGISTERS]; /* of a scaled one */
};

/* sum_{j=from}^{k} u_j w_{k-j} */
static struct interval sum(const struct interval u[], const struct interval w[],
                           size_t from, size_t k)
{
    struct interval s = { 0, 0 };

    for (size_t j = from; j <= k; j++)
        s = interval_add(s, interval_times(u[j], w[k - j]));
    return s;
}

/* sum_{j=1}^{to} j u_j d_{k-j} */
static struct interval chain_sum(const struct interval u[],
                                 const struct interval d[], size_t to, size_t k)
{
    struct interval s = { 0, 0 };

    for (size_t j = 1; j <= to; j++)
        s = interval_add(s, interval_times(interval_times(u[j], d[k - j]),
                                           point((double) j)));
    return s;
}

/* Coefficient k > 0 of w with w' = d u'. */
static struct interval chain(const struct interval u[],
                             const struct interval d[], size_t k)
{
    return interval_divide(chain_sum(u, d, k, k), point((double) k));
}

static struct interval constant(const struct run *r, int node)
{
    return r->t->constant[node];
}

/* The terms of a form. */
static void terms(const struct run *r, const struct linear *u,
                  struct interval out[])
{
    for (size_t k = 0; k <= r->n; k++) {
        out[k] = point(0);
        for (int i = 0; i < u->terms; i++)
            out[k] = interval_add(out[k],
                                  interval_times(constant(r, u->term[i].c),
                                                 r->reg[u->term[i].reg].c[k]));
    }
}

static void linear(const struct run *r, const struct linear *u,
                   struct interval out[])
{
    terms(r, u, out);
    out[0] = interval_add(out[0], constant(r, u->constant));
}

/* e^u to order n of what is e0 at order 0 */
static void exponential(size_t n, const struct interval u[], struct interval e0,
                        struct interval out[])
{
    out[0] = e0;
    for (size_t k = 1; k <= n; k++)
        out[k] = chain(u, out, k);
}

/* ---- steps --------------------------------------------------------------- */

/* ln of k e^u */
static struct interval grown(const struct run *r, const struct step *s)
{
    return s->b >= 0 ? r->reg[s->b].c[0]
                     : interval_add(constant(r, s->q), r->reg[s->a].c[0]);
}

static struct interval less(struct interval u, double x)
{
    return interval_less(u, point(x));
}

/* k (e^u - 1) e^-s: k e^u is its own derivative. */
static void growth(const struct run *r, const struct step *s, double scale,
                   struct interval out[])
{
    const struct interval *u = r->reg[s->a].c;
    const struct interval e = interval_exp(less(grown(r, s), scale));
    const struct interval k =
        interval_times(constant(r, s->k), interval_exp(point(-scale)));
    const struct interval apart = interval_less(e, k);

    exponential(r->n, u, e, out);
    out[0] = u[0].hi < 700
                 ? interval_both(apart, interval_times(k, interval_expm1(u[0])))
                 : apart;
}

/* k (e^u - e^(w + q)) e^-s */
static void apart(struct run *r, const struct step *s, double scale,
                  struct interval out[])
{
    const struct interval *u = r->reg[s->a].c, *w = r->reg[s->b].c;
    const struct interval k = constant(r, s->k);
    const struct interval wq = interval_add(w[0], constant(r, s->q));
    const struct interval large =
        interval_times(k, interval_exp(less(u[0], scale)));
    const struct interval small =
        interval_times(k, interval_exp(less(wq, scale)));
    const struct interval gap = interval_less(wq, u[0]);
    struct interval *one = r->keep[0].c, *two = r->keep[1].c;

    exponential(r->n, u, large, one);
    exponential(r->n, w, small, two);
    for (size_t j = 0; j <= r->n; j++)
        out[j] = interval_less(one[j], two[j]);
    if (gap.hi < 700)
        out[0] = interval_both(
            out[0], interval_minus(interval_times(large, interval_expm1(gap))));
}

/* w' = p u' with the logistic p, p' = (1 - p) w' */
static void mixed(struct run *r, const struct step *s, struct interval out[])
{
    const struct interval *u = r->reg[s->a].c;
    const struct interval k = constant(r, s->k), q = constant(r, s->q);
    struct interval *p = r->keep[0].c, *rest = r->keep[1].c;

    out[0] = interval_mixed(k, q, u[0]);
    p[0] = interval_mixed_slope(k, q, u[0]);
    rest[0] = interval_mixed_slope(q, k, interval_minus(u[0]));
    for (size_t j = 1; j <= r->n; j++) {
        out[j] = chain(u, p, j);
        p[j] = chain(out, rest, j);
        rest[j] = interval_minus(p[j]);
    }
}

/* ln(1 + u/k): (k + u) w' = u' */
static void ln1p(struct run *r, const struct step *s, struct interval out[])
{
    const struct interval *u = r->reg[s->a].c;
    const struct interval k = constant(r, s->k);
    struct interval *d = r->keep[0].c;

    memcpy(d, u, (r->n + 1) * sizeof *d);
    d[0] = interval_add(k, u[0]);
    out[0] = interval_ln1p(interval_divide(u[0], k));
    for (size_t j = 1; j <= r->n; j++) {
        const struct interval known =
            interval_divide(chain_sum(out, d, j - 1, j), point((double) j));
        out[j] = interval_divide(interval_less(u[j], known), d[0]);
    }
}

/* e^-|w| sinh w as s (1 - e^(-2 s w))/2 with the sign s of the middle of w,
 * which is e^(-s w) sinh w for every w: its derivative is e^(-2 s w). */
static void sinh_less(struct run *r, const struct step *s, double *sign,
                      struct interval out[])
{
    const struct interval *u = r->reg[s->a].c;
    const struct interval w = interval_add(constant(r, s->k), u[0]);
    struct interval *e = r->keep[0].c;

    *sign = interval_middle(w) < 0 ? -1 : 1;
    const struct interval v = interval_times(point(-2 * *sign), w);
    e[0] = interval_exp(v);
    out[0] = interval_times(point(-*sign / 2), interval_expm1(v));
    for (size_t j = 1; j <= r->n; j++) {
        out[j] = chain(u, e, j);
        e[j] = interval_times(point(-2 * *sign), out[j]);
    }
}

/* m = asinh(e^w/2): m' = t w', t = tanh m = (1 + 4 e^(-2 w))^(-1/2),
 * t' = b m', b = 1 - t^2 = 1/(1 + e^(2 w)/4). */
static void friction(struct run *r, const struct step *s, struct interval out[])
{
    const struct interval *u = r->reg[s->a].c, one = point(1);
    const struct interval k = constant(r, s->k), w = interval_add(k, u[0]);
    struct interval *t = r->keep[0].c, *b = r->keep[1].c;
    const struct interval e2 = interval_exp(interval_times(point(2), w));
    const struct interval down = interval_exp(interval_times(point(-2), w));

    out[0] = interval_friction(k, u[0]);
    t[0] = w.hi > 0
               ? interval_divide(one, interval_sqrt(interval_add(
                                          one, interval_times(point(4), down))))
               : interval_divide(interval_exp(w),
                                 interval_sqrt(interval_add(point(4), e2)));
    b[0] = interval_divide(one,
                           interval_add(one, interval_times(point(0.25), e2)));
    for (size_t j = 1; j <= r->n; j++) {
        out[j] = chain(u, t, j);
        t[j] = chain(out, b, j);
        b[j] = interval_minus(sum(t, t, 0, j));
    }
}

static void product(const struct run *r, const struct interval u[],
                    const struct interval w[], struct interval out[])
{
    for (size_t k = 0; k <= r->n; k++)
        out[k] = sum(u, w, 0, k);
}

/* u/(k + w) */
static void quotient(struct run *r, const struct step *s, struct interval out[])
{
    const struct interval *u = r->reg[s->a].c, *w = r->reg[s->b].c;
    const struct interval under = interval_add(constant(r, s->k), w[0]);

    for (size_t k = 0; k <= r->n; k++) {
        struct interval left = u[k];
        for (size_t j = 0; j < k; j++)
            left = interval_less(left, interval_times(out[j], w[k - j]));
        out[k] = interval_divide(left, under);
    }
}

static bool grows(const struct run *r, int reg)
{
    return reg >= 2 && (r->t->t->step[reg - 2].kind == STEP_GROWTH ||
                        r->t->t->step[reg - 2].kind == STEP_APART);
}

/* About the largest exponent of the parts; any number will do. */
static double scale_of(const struct run *r, const struct step *s)
{
    double scale = 0;

    for (int i = 0; i < s->form.terms; i++) {
        const int reg = s->form.term[i].reg;
        if (!grows(r, reg))
            continue;
        const struct step *g = &r->t->t->step[reg - 2];
        const double u = g->kind == STEP_GROWTH
                             ? interval_middle(grown(r, g))
                             : fmax(interval_middle(r->reg[g->a].c[0]),
                                    interval_middle(r->reg[g->b].c[0]) +
                                        interval_middle(constant(r, g->q)));
        scale = u > scale ? u : scale;
    }
    return scale < 1e300 ? scale : 1e300;
}

/* The form times e^-scale. */
static void scaled(struct run *r, const struct step *s, double scale,
                   struct interval out[])
{
    const struct interval by = interval_exp(point(-scale));
    struct interval part[JET_SIZE];

    for (size_t k = 0; k <= r->n; k++)
        out[k] = k == 0 ? interval_times(constant(r, s->form.constant), by)
                        : point(0);
    for (int i = 0; i < s->form.terms; i++) {
        const int reg = s->form.term[i].reg;
        const struct interval c = constant(r, s->form.term[i].c);
        if (!grows(r, reg))
            for (size_t k = 0; k <= r->n; k++)
                part[k] = interval_times(r->reg[reg].c[k], by);
        else if (r->t->t->step[reg - 2].kind == STEP_GROWTH)
            growth(r, &r->t->t->step[reg - 2], scale, part);
        else
            apart(r, &r->t->t->step[reg - 2], scale, part);
        for (size_t k = 0; k <= r->n; k++)
            out[k] = interval_add(out[k], interval_times(c, part[k]));
    }
}

static void step(struct run *r, int i)
{
    const struct step *s = &r->t->t->step[i];
    struct interval *out = r->reg[i + 2].c;

    switch (s->kind) {
        case STEP_LINEAR:
            linear(r, &s->form, out);
            return;
        case STEP_GROWTH:
            growth(r, s, 0, out);
            return;
        case STEP_APART:
            apart(r, s, 0, out);
            return;
        case STEP_EXP:
            exponential(r->n, r->reg[s->a].c,
                        interval_exp(
                            interval_add(constant(r, s->q), r->reg[s->a].c[0])),
                        out);
            return;
        case STEP_MIXED:
            mixed(r, s, out);
            return;
        case STEP_LN1P:
            ln1p(r, s, out);
            return;
        case STEP_SINH:
            sinh_less(r, s, &r->sign[i + 2], out);
            return;
        case STEP_FRICTION:
            friction(r, s, out);
            return;
        case STEP_PRODUCT:
            product(r, r->reg[s->a].c, r->reg[s->b].c, out);
            return;
        case STEP_QUOTIENT:
            quotient(r, s, out);
            return;
        case STEP_SCALED:
            r->scale[i + 2] = scale_of(r, s);
            scaled(r, s, r->scale[i + 2], out);
            return;
        default:
            return; /* not used */
    }
}

/* ---- rates --------------------------------------------------------------- */

/* Which exponent goes with the sign taken; of its two forms, which are equal,
 * the one without growths where all of these have shrunk to 1/e. */
static int exponent_of(const struct run *r, const struct tape_rate *p)
{
    const int minus = p->sinh >= 0 && r->sign[p->sinh] < 0;
    const struct linear *near = &p->exponent[minus + TAPE_NEAR];

    for (int i = 0; i < near->terms; i++) {
        const int reg = near->term[i].reg;
        if (reg >= 2 && r->t->t->step[reg - 2].kind == STEP_GROWTH &&
            interval_middle(r->reg[r->t->t->step[reg - 2].a].c[0]) > -1)
            return minus + TAPE_NEAR;
    }
    return minus;
}

static void run_steps(struct run *r, const struct interval x[],
                      const struct interval y[])
{
    memcpy(r->reg[0].c, x, (r->n + 1) * sizeof *x);
    memcpy(r->reg[1].c, y, (r->n + 1) * sizeof *y);
    for (int i = 0; i < r->t->t->steps; i++)
        if (r->t->used[i])
            step(r, i);
}

/* A rate's exponent but for what is in `part`. */
struct exponent {
    struct interval c[JET_SIZE];
    int which;
    double whole;
};

static void make_exponent(const struct run *r, int i, struct exponent *e)
{
    const struct tape_rate *p = &r->t->t->rate[r->t->rate[i]];

    e->which = exponent_of(r, p);
    e->whole = r->t->whole[i][e->which];
    terms(r, &p->exponent[e->which], e->c);
    if (p->scaled >= 0)
        e->c[0] = interval_add(e->c[0], point(r->scale[p->scaled]));
}

/* A whole number near the larger exponent of the chart's rates. */
static double scale_of_rates(const struct exponent e[])
{
    double most = -HUGE_VAL;

    for (int i = 0; i < 2; i++)
        most = fmax(most, interval_middle(e[i].c[0]) + e[i].whole);
    return fabs(most) < 0x1p50 ? rint(most) : 0;
}

void interval_tape_jet(struct interval_tape *t, size_t n,
                       const struct interval x[], const struct interval y[],
                       struct interval_series out[], double *log_scale)
{
    struct run r = {
        .t = t, .n = n, .reg = t->series, .keep = t->series + REGISTERS
    };
    struct exponent e[TAPE_RATES];
    struct interval m[JET_SIZE], power[JET_SIZE];

    run_steps(&r, x, y);
    for (int i = 0; i < t->rates; i++)
        make_exponent(&r, i, &e[i]);
    *log_scale = scale_of_rates(e);
    for (int i = 0; i < t->rates; i++) {
        /* exact: both are whole and below 2^52 */
        const struct interval whole = point(e[i].whole - *log_scale);
        const struct interval e0 =
            interval_times(t->part[i][e[i].which],
                           interval_exp(interval_add(e[i].c[0], whole)));
        linear(&r, &t->t->rate[t->rate[i]].mantissa, m);
        exponential(n, e[i].c, e0, power);
        product(&r, m, power, out[i].c);
    }
}

struct interval interval_tape_change(struct interval_tape *t, struct interval x,
                                     struct interval y)
{
    struct run r = { .t = t, .reg = t->series, .keep = t->series + REGISTERS };
    struct linear change = t->t->value[0];
    struct interval sum[JET_SIZE];

    run_steps(&r, &x, &y);
    change.constant = 0; /* node 0 is the number 0 */
    linear(&r, &change, sum);
    return sum[0];
}
