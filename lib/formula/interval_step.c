/* A step at a time, each by the recurrence of tape_jet.c with intervals in
 * place of numbers: for w = f(u), k w_k is the convolution of j u_j with
 * f'(u), of which f'(u) at order 0 and its own derivative are known. */
#include "interval_step.h"

#include <string.h>

#include "interval_math.h"

static struct interval point(long double x)
{
    return interval_point(x);
}

/* ---- series ------------------------------------------------------------- */

static struct interval constant(const struct interval_run *r, int node)
{
    return r->t->constant[node];
}

/* The terms of a form. */
void interval_terms(const struct interval_run *r, const struct linear *u,
                    struct interval out[])
{
    for (size_t k = 0; k <= r->n; k++) {
        out[k] = point(0);
        for (int i = 0; i < u->terms; i++) {
            const struct interval w = r->reg[u->term[i].reg].c[k];
            if (!interval_is_zero(w))
                out[k] = interval_add(
                    out[k], interval_times(constant(r, u->term[i].c), w));
        }
    }
}

void interval_linear(const struct interval_run *r, const struct linear *u,
                     struct interval out[])
{
    interval_terms(r, u, out);
    out[0] = interval_add(out[0], constant(r, u->constant));
}

/* ---- steps --------------------------------------------------------------- */

/* ln of k e^u */
static struct interval grown(const struct interval_run *r, const struct step *s)
{
    return s->b >= 0 ? r->reg[s->b].c[0]
                     : interval_add(constant(r, s->q), r->reg[s->a].c[0]);
}

static struct interval less(struct interval u, long double x)
{
    return interval_less(u, point(x));
}

/* k (e^u - 1) e^-s: k e^u is its own derivative; k = 0: e^(q + u - s). */
static void growth(const struct interval_run *r, const struct step *s,
                   double scale, struct interval out[])
{
    const struct interval *u = r->reg[s->a].c;
    const struct interval e = interval_exp(less(grown(r, s), scale));
    const struct interval k =
        interval_times(constant(r, s->k), interval_exp(point(-scale)));
    const struct interval apart = interval_less(e, k);

    interval_exponential(r->n, u, e, out);
    out[0] = u[0].hi < 700 && !interval_is_zero(k)
                 ? interval_both(apart, interval_times(k, interval_expm1(u[0])))
                 : apart;
}

/* k (e^u - e^(w + q)) e^-s */
static void apart(struct interval_run *r, const struct step *s, double scale,
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

    interval_exponential(r->n, u, large, one);
    interval_exponential(r->n, w, small, two);
    for (size_t j = 0; j <= r->n; j++)
        out[j] = interval_less(one[j], two[j]);
    if (gap.hi < 700)
        out[0] = interval_both(
            out[0], interval_minus(interval_times(large, interval_expm1(gap))));
}

/* w' = p u' with the logistic p, p' = (1 - p) w' */
static void mixed(struct interval_run *r, const struct step *s,
                  struct interval out[])
{
    const struct interval *u = r->reg[s->a].c;
    const struct interval k = constant(r, s->k), q = constant(r, s->q);
    struct interval *p = r->keep[0].c, *rest = r->keep[1].c;

    out[0] = interval_mixed(k, q, u[0]);
    p[0] = interval_mixed_slope(k, q, u[0]);
    rest[0] = interval_mixed_slope(q, k, interval_minus(u[0]));
    const struct interval_row U = interval_row_of(u, r->n);
    struct interval_row P = interval_row_of(p, 0), W = interval_row_of(out, 0),
                        R = interval_row_of(rest, 0);
    for (size_t j = 1; j <= r->n; j++) {
        out[j] = interval_chain(&U, &P, j);
        interval_row_take(&W, j);
        p[j] = interval_chain(&W, &R, j);
        rest[j] = interval_minus(p[j]);
        interval_row_take(&P, j);
        interval_row_take(&R, j);
    }
}

/* Orders above 0 of w with d w' = u'. */
static void under(const struct interval_run *r, const struct interval u[],
                  const struct interval d[], struct interval out[])
{
    const struct interval_row D = interval_row_of(d, r->n);
    struct interval_row W = interval_row_of(out, 0);

    for (size_t j = 1; j <= r->n; j++) {
        const struct interval known =
            interval_sum(j - 1, 1, &W, 1, &D, j - 1, (long double) j);
        out[j] = interval_divide(interval_less(u[j], known), d[0]);
        interval_row_take(&W, j);
    }
}

/* ln(1 + u/k): (k + u) w' = u' */
static void ln1p(struct interval_run *r, const struct step *s,
                 struct interval out[])
{
    const struct interval *u = r->reg[s->a].c;
    const struct interval k = constant(r, s->k);
    struct interval *d = r->keep[0].c;

    memcpy(d, u, (r->n + 1) * sizeof *d);
    d[0] = interval_add(k, u[0]);
    out[0] = interval_ln1p(interval_divide(u[0], k));
    under(r, u, d, out);
}

/* e^-|w| sinh w as s (1 - e^(-2 s w))/2 with the sign s of the middle of w,
 * which is e^(-s w) sinh w for every w: its derivative is e^(-2 s w). */
static void sinh_less(struct interval_run *r, const struct step *s,
                      double *sign, struct interval out[])
{
    const struct interval *u = r->reg[s->a].c;
    const struct interval w = interval_add(constant(r, s->k), u[0]);
    struct interval *e = r->keep[0].c;

    *sign = interval_middle(w) < 0 ? -1 : 1;
    const struct interval v = interval_times(point(-2 * *sign), w);
    e[0] = interval_exp(v);
    out[0] = interval_times(point(-*sign / 2), interval_expm1(v));
    const struct interval_row U = interval_row_of(u, r->n);
    struct interval_row E = interval_row_of(e, 0);
    for (size_t j = 1; j <= r->n; j++) {
        out[j] = interval_chain(&U, &E, j);
        e[j] = interval_times(point(-2 * *sign), out[j]);
        interval_row_take(&E, j);
    }
}

/* m = asinh(e^w/2): m' = t w', t = tanh m = (1 + 4 e^(-2 w))^(-1/2),
 * t' = b m', b = 1 - t^2 = 1/(1 + e^(2 w)/4). */
static void friction(struct interval_run *r, const struct step *s,
                     struct interval out[])
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
    const struct interval_row U = interval_row_of(u, r->n);
    struct interval_row T = interval_row_of(t, 0), M = interval_row_of(out, 0),
                        B = interval_row_of(b, 0);
    for (size_t j = 1; j <= r->n; j++) {
        out[j] = interval_chain(&U, &T, j);
        interval_row_take(&M, j);
        t[j] = interval_chain(&M, &B, j);
        interval_row_take(&T, j);
        b[j] = interval_minus(interval_sum(j + 1, 0, &T, 0, &T, j, 1));
        interval_row_take(&B, j);
    }
}

/* ---- functions that are not made of exponentials ------------------------ */

/* f(k + u) - f(k), also by its slope over all that is between: no digits are
 * lost as u vanishes. */
static struct interval change(enum formula_function f, struct interval k,
                              struct interval u, struct interval slope)
{
    const struct interval w = interval_add(k, u);

    return interval_both(
        interval_less(interval_function(f, w), interval_function(f, k)),
        interval_times(slope, u));
}

/* Orders above 0 of a and b with a' = b u', b' = sign a u'. */
static void turn(const struct interval_run *r, const struct interval u[],
                 double sign, struct interval a[], struct interval b[],
                 struct interval out[])
{
    const struct interval_row U = interval_row_of(u, r->n);
    struct interval_row A = interval_row_of(a, 0), B = interval_row_of(b, 0);

    for (size_t j = 1; j <= r->n; j++) {
        out[j] = a[j] = interval_chain(&U, &B, j);
        b[j] = interval_times(point(sign), interval_chain(&U, &A, j));
        interval_row_take(&A, j);
        interval_row_take(&B, j);
    }
}

/* k (cos u - 1) + q sin u = -2 k sin^2(u/2) + q sin u; the sine S = k + that
 * and its slope C: S' = C u', C' = -S u'. */
static void sine(struct interval_run *r, const struct step *s,
                 struct interval out[])
{
    const struct interval *u = r->reg[s->a].c, one = { -1, 1 };
    const struct interval k = constant(r, s->k), q = constant(r, s->q);
    const struct interval half =
        interval_function(FUNCTION_SIN, interval_times(point(0.5), u[0]));
    const struct interval sin = interval_function(FUNCTION_SIN, u[0]);
    const struct interval cos = interval_function(FUNCTION_COS, u[0]);
    struct interval *S = r->keep[0].c, *C = r->keep[1].c;

    out[0] = interval_less(
        interval_times(q, sin),
        interval_times(k,
                       interval_times(point(2), interval_times(half, half))));
    S[0] = interval_both(interval_add(k, out[0]), one);
    C[0] = interval_both(
        interval_less(interval_times(q, cos), interval_times(k, sin)), one);
    turn(r, u, -1, S, C, out);
}

/* C = cosh, S = sinh of k + u: C' = S u', S' = C u'. */
static void cosine(struct interval_run *r, const struct step *s,
                   struct interval out[])
{
    const struct interval *u = r->reg[s->a].c, k = constant(r, s->k);
    const struct interval w = interval_add(k, u[0]);
    struct interval *C = r->keep[0].c, *S = r->keep[1].c;

    out[0] = change(FUNCTION_COSH, k, u[0], interval_sinh(interval_hull(k, w)));
    C[0] = interval_function(FUNCTION_COSH, w);
    S[0] = interval_sinh(w);
    turn(r, u, 1, C, S, out);
}

/* Tangents t of k + u, t' = d u' with d = 1 + sign t^2, sign -1: hyperbolic. */
static void tangent(struct interval_run *r, const struct step *s,
                    enum formula_function f, double sign, struct interval out[])
{
    const struct interval *u = r->reg[s->a].c, k = constant(r, s->k);
    const struct interval w = interval_add(k, u[0]);
    const struct interval all = interval_function(f, interval_hull(k, w));
    struct interval *t = r->keep[0].c, *d = r->keep[1].c;

    t[0] = interval_function(f, w);
    const struct interval_row U = interval_row_of(u, r->n);
    struct interval_row T = { .c = t }, D = { .c = d };
    for (size_t j = 0; j <= r->n; j++) {
        if (j > 0)
            out[j] = t[j] = interval_chain(&U, &D, j);
        interval_row_take(&T, j);
        d[j] = interval_times(point(sign),
                              interval_sum(j + 1, 0, &T, 0, &T, j, 1));
        if (j == 0)
            d[j] = interval_add(point(1), d[j]);
        interval_row_take(&D, j);
    }
    out[0] = change(
        f, k, u[0],
        interval_add(point(1),
                     interval_times(point(sign), interval_times(all, all))));
}

/* 1 + sign w^2, or its root */
static struct interval length(struct interval w, double sign, bool root)
{
    const struct interval most = point(interval_most(w)),
                          least = point(interval_least(w));
    const struct interval square = { interval_times(least, least).lo,
                                     interval_times(most, most).hi };
    const struct interval sum =
        interval_add(point(1), interval_times(point(sign), square));

    return root ? interval_sqrt(sum) : sum;
}

/* Inverse functions f of k + u: d f' = u' with d = 1 + w^2 of the arctangent,
 * the root of 1 - w^2 or of 1 + w^2 of the others: d^2 = that. */
static void arc(struct interval_run *r, const struct step *s,
                enum formula_function f, double sign, struct interval out[])
{
    const bool root = f != FUNCTION_ATAN;
    const struct interval *u = r->reg[s->a].c, k = constant(r, s->k);
    struct interval *w = r->keep[0].c, *d = r->keep[1].c;

    memcpy(w, u, (r->n + 1) * sizeof *w);
    w[0] = interval_add(k, u[0]);
    d[0] = length(w[0], sign, root);
    const struct interval_row W = interval_row_of(w, r->n);
    for (size_t j = 1; j <= r->n; j++) {
        d[j] = interval_times(point(sign),
                              interval_sum(j + 1, 0, &W, 0, &W, j, 1));
        for (size_t i = 1; root && i < j; i++)
            d[j] = interval_less(d[j], interval_times(d[i], d[j - i]));
        if (root)
            d[j] = interval_divide(d[j], interval_times(point(2), d[0]));
    }
    out[0] = change(
        f, k, u[0],
        interval_divide(point(1), length(interval_hull(k, w[0]), sign, root)));
    under(r, u, d, out);
}

/* ---- products, and forms with scales ------------------------------------- */

/* u/(k + w) */
static void quotient(struct interval_run *r, const struct step *s,
                     struct interval out[])
{
    const struct interval *u = r->reg[s->a].c, *w = r->reg[s->b].c;
    const struct interval under = interval_add(constant(r, s->k), w[0]);

    const struct interval_row W = interval_row_of(w, r->n);
    struct interval_row made = { .c = out };
    for (size_t k = 0; k <= r->n; k++) {
        const struct interval known = interval_sum(k, 0, &made, 0, &W, k, 1);
        out[k] = interval_divide(interval_less(u[k], known), under);
        interval_row_take(&made, k);
    }
}

/* About the largest exponent of the parts; any number will do. */
static double scale_of(const struct interval_run *r, const struct step *s)
{
    double scale = 0;

    for (int i = 0; i < s->form.terms; i++) {
        const int reg = s->form.term[i].reg;
        if (!tape_grows(r->t->t, reg))
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
static void scaled(struct interval_run *r, const struct step *s, double scale,
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
        if (!tape_grows(r->t->t, reg))
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

/* Those that are not made of exponentials. */
static void function_step(struct interval_run *r, const struct step *s,
                          struct interval out[])
{
    switch (s->kind) {
        case STEP_SIN:
            sine(r, s, out);
            return;
        case STEP_COSH:
            cosine(r, s, out);
            return;
        case STEP_TAN:
            tangent(r, s, FUNCTION_TAN, 1, out);
            return;
        case STEP_TANH:
            tangent(r, s, FUNCTION_TANH, -1, out);
            return;
        case STEP_ASIN:
            arc(r, s, FUNCTION_ASIN, -1, out);
            return;
        case STEP_ATAN:
            arc(r, s, FUNCTION_ATAN, 1, out);
            return;
        default: /* STEP_ASINH */
            arc(r, s, FUNCTION_ASINH, 1, out);
            return;
    }
}

void interval_step(struct interval_run *r, int i)
{
    const struct step *s = &r->t->t->step[i];
    struct interval *out = r->reg[i + 2].c;

    switch (s->kind) {
        case STEP_LINEAR:
            interval_linear(r, &s->form, out);
            return;
        case STEP_GROWTH:
            growth(r, s, 0, out);
            return;
        case STEP_APART:
            apart(r, s, 0, out);
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
            interval_product(r->n, r->reg[s->a].c, r->reg[s->b].c, out);
            return;
        case STEP_QUOTIENT:
            quotient(r, s, out);
            return;
        case STEP_SCALED:
            r->scale[i + 2] = scale_of(r, s);
            scaled(r, s, r->scale[i + 2], out);
            return;
        default:
            function_step(r, s, out);
            return;
    }
}
