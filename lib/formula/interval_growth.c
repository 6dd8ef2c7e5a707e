#include "interval_growth.h"

#include <math.h>
#include <stdlib.h>

#include "interval_math.h"

static const struct interval all = { -HUGE_VAL, HUGE_VAL };

static struct interval point(long double x)
{
    return interval_point(x);
}

static struct growth number(struct interval c)
{
    return (struct growth){ { 0, 0 }, { 0, 0 }, c, c };
}

/* ---- arithmetic ---------------------------------------------------------- */

/* p x + q y */
static struct interval form(const struct interval_growth *w, long double p,
                            long double q)
{
    return interval_add(interval_times(point(p), w->at[0]),
                        interval_times(point(q), w->at[1]));
}

static bool has(const long double u[2])
{
    return u[0] < 0 || u[0] > 0 || u[1] < 0 || u[1] > 0;
}

/* Each enclosure by the other. */
static struct growth made(const struct interval_growth *w, struct growth u)
{
    const struct interval part =
        interval_times(u.c, interval_exp(form(w, u.power[0], u.power[1])));

    u.all = interval_both(u.all,
                          interval_add(part, form(w, u.slope[0], u.slope[1])));
    if (!has(u.power) && !has(u.slope))
        u.c = u.all;
    return u;
}

/* Without slopes. */
static struct growth level(struct growth u)
{
    return has(u.slope) ? number(u.all) : u;
}

static bool is_exact(long double u, long double w)
{
    const long double p = u * w, off = fmal(u, w, -p);

    return !(off < 0 || off > 0);
}

/* The slopes times a number, if they are exact. */
static bool scale(struct growth *u, const struct growth *by)
{
    if (!has(u->slope) || has(by->power) || has(by->slope) ||
        by->c.lo < by->c.hi || !is_exact(u->slope[0], by->c.lo) ||
        !is_exact(u->slope[1], by->c.lo))
        return false;
    for (int i = 0; i < 2; i++)
        u->slope[i] *= by->c.lo;
    u->c = interval_times(u->c, by->c);
    return true;
}

static struct growth times(const struct interval_growth *w, struct growth u,
                           struct growth v)
{
    struct growth out = u, other = v;

    if (!scale(&out, &v)) {
        if (scale(&other, &u)) {
            out = other;
        } else {
            out = level(u);
            other = level(v);
            for (int i = 0; i < 2; i++)
                out.power[i] += other.power[i];
            out.c = interval_times(out.c, other.c);
        }
    }
    out.all = interval_times(u.all, v.all);
    return made(w, out);
}

static struct growth over(const struct interval_growth *w, struct growth u,
                          struct growth v)
{
    struct growth out = level(u);

    v = level(v);
    for (int i = 0; i < 2; i++)
        out.power[i] -= v.power[i];
    out.c = interval_divide(out.c, v.c);
    out.all = interval_divide(u.all, v.all);
    return made(w, out);
}

static struct growth minus(struct growth u)
{
    for (int i = 0; i < 2; i++)
        u.slope[i] = -u.slope[i];
    u.c = interval_minus(u.c);
    u.all = interval_minus(u.all);
    return u;
}

static bool is_zero(struct growth u)
{
    return u.all.lo >= 0 && u.all.hi <= 0;
}

static bool has_zero(struct growth u)
{
    return !(u.all.lo > 0 || u.all.hi < 0);
}

/* Of two of one sign at least as large as either. */
static struct interval sum_of(struct interval u, struct interval v)
{
    struct interval out = interval_add(u, v);

    if (u.lo >= 0 && v.lo >= 0)
        out.lo = fmaxl(out.lo, fmaxl(u.lo, v.lo));
    if (u.hi <= 0 && v.hi <= 0)
        out.hi = fminl(out.hi, fminl(u.hi, v.hi));
    return out;
}

/* Whether u + v has no rounding: the parts of each that the other lacks. */
static bool is_sum(const long double u[2], const long double v[2])
{
    for (int i = 0; i < 2; i++) {
        const long double s = u[i] + v[i], b = s - u[i];
        const long double off = (u[i] - (s - b)) + (v[i] - b);
        if (off < 0 || off > 0)
            return false;
    }
    return true;
}

/* By the powers with which neither term grows where the box has no end. */
static struct growth sum(const struct interval_growth *w, struct growth u,
                         struct growth v)
{
    struct growth out = u;

    if (is_zero(u) || is_zero(v))
        return is_zero(u) ? v : u;
    if (has(u.power) || has(v.power)) {
        out = u = level(u);
        v = level(v);
    }
    for (int i = 0; i < 2; i++) {
        out.power[i] = w->at[i].lo > -HUGE_VAL ? fmaxl(u.power[i], v.power[i])
                                               : fminl(u.power[i], v.power[i]);
        out.slope[i] = u.slope[i] + v.slope[i];
    }
    if (!is_sum(u.slope, v.slope))
        return number(sum_of(u.all, v.all));
    out.c = sum_of(
        interval_times(u.c, interval_exp(form(w, u.power[0] - out.power[0],
                                              u.power[1] - out.power[1]))),
        interval_times(v.c, interval_exp(form(w, v.power[0] - out.power[0],
                                              v.power[1] - out.power[1]))));
    out.all = sum_of(u.all, v.all);
    return made(w, out);
}

static struct growth less(const struct interval_growth *w, struct growth u,
                          struct growth v)
{
    return sum(w, u, minus(v));
}

/* ---- rules --------------------------------------------------------------- */

/* Of a node: value, derivative, that of the logarithm. */
struct jet1 {
    struct growth value, by, rate;
};

static struct jet1 constant(struct interval c)
{
    return (struct jet1){ number(c), number(point(0)), number(point(0)) };
}

static struct jet1 get(const struct interval_growth *w, int i)
{
    return (struct jet1){ w->value[i], w->by[i], w->rate[i] };
}

/* (ln |u + v|)', u not 0: with r = v/u, v/(u + v) = r/(1 + r) = 1 - 1/(1 + r).
 */
static struct growth rate_of_sum(const struct interval_growth *w,
                                 const struct jet1 *u, const struct jet1 *v)
{
    const struct interval r = over(w, v->value, u->value).all;
    const struct interval s = interval_add(point(1), r);
    const struct interval part =
        interval_both(interval_divide(r, s),
                      interval_less(point(1), interval_divide(point(1), s)));

    return s.lo > 0 || s.hi < 0
               ? sum(w, u->rate,
                     times(w, number(part), less(w, v->rate, u->rate)))
               : number(all);
}

static struct jet1 add(const struct interval_growth *w, struct jet1 u,
                       struct jet1 v)
{
    struct jet1 out = { sum(w, u.value, v.value), sum(w, u.by, v.by),
                        number(all) };

    if (is_zero(u.value) || is_zero(v.value))
        return is_zero(u.value) ? v : u;
    if (!has_zero(u.value))
        out.rate = rate_of_sum(w, &u, &v);
    else if (!has_zero(v.value))
        out.rate = rate_of_sum(w, &v, &u);
    return out;
}

static struct jet1 product(const struct interval_growth *w, struct jet1 u,
                           struct jet1 v)
{
    return (
        struct jet1){ times(w, u.value, v.value),
                      sum(w, times(w, u.by, v.value), times(w, u.value, v.by)),
                      sum(w, u.rate, v.rate) };
}

static struct jet1 quotient(const struct interval_growth *w, struct jet1 u,
                            struct jet1 v)
{
    const struct growth q = over(w, u.value, v.value);

    return (struct jet1){ q, over(w, less(w, u.by, times(w, q, v.by)), v.value),
                          less(w, u.rate, v.rate) };
}

/* e^u: of slopes a power. */
static struct jet1 exponential(const struct interval_growth *w, struct jet1 u)
{
    struct growth value = { { u.value.slope[0], u.value.slope[1] },
                            { 0, 0 },
                            interval_exp(u.value.all),
                            interval_exp(u.value.all) };

    if (has(value.power))
        value.c = interval_exp(u.value.c);
    value = made(w, value);
    return (struct jet1){ value, times(w, value, u.by), u.by };
}

static struct jet1 unknown(void)
{
    return (struct jet1){ number(all), number(all), number(all) };
}

/* Of what is > 0: of a power slopes. */
static struct jet1 logarithm(const struct interval_growth *w, struct jet1 u)
{
    const struct growth v = level(u.value);
    struct growth value = { { 0, 0 },
                            { v.power[0], v.power[1] },
                            interval_ln(v.c),
                            interval_ln(v.all) };

    if (!(v.c.lo > 0))
        return unknown();
    value = made(w, value);
    return (struct jet1){ value, u.rate, over(w, u.rate, value) };
}

/* u^n of any u, n u^(n - 1) u' and n (ln u)'; of n < 0 one over u^-n. */
static struct jet1 whole_power(const struct interval_growth *w, struct jet1 u,
                               long n)
{
    const struct interval m = point(labs(n)), all_of = u.value.all;
    const struct growth slope =
        number(interval_times(m, interval_power(all_of, labs(n) - (n != 0))));
    const struct jet1 out = { number(interval_power(all_of, labs(n))),
                              times(w, slope, u.by),
                              times(w, number(m), u.rate) };

    return n < 0 ? quotient(w, constant(point(1)), out) : out;
}

/* Of what is > 0, and whole ones. */
static struct jet1 power(const struct interval_growth *w, struct jet1 u,
                         struct jet1 p)
{
    const struct interval n = p.value.all;

    if (level(u.value).c.lo > 0)
        return exponential(w, product(w, p, logarithm(w, u)));
    return floorl(n.lo) >= n.hi && is_zero(p.by) && fabsl(n.lo) < 1e9
               ? whole_power(w, u, (long) n.lo)
               : unknown();
}

/* f(u) with the slope f'(u). */
static struct jet1 function(const struct interval_growth *w,
                            struct interval value, struct interval slope,
                            struct jet1 u)
{
    const struct growth by = times(w, number(slope), u.by);

    return (struct jet1){ number(value), by, over(w, by, number(value)) };
}

/* K = sinh u: (ln K)' = coth(u) u', and |coth| falls to 1 as |u| grows. */
static struct jet1 hyperbolic(const struct interval_growth *w, struct jet1 u)
{
    const struct interval u0 = u.value.all;
    struct jet1 out =
        function(w, interval_sinh(u0), interval_function(FUNCTION_COSH, u0), u);

    if (!has_zero(u.value))
        out.rate = times(w,
                         number(interval_divide(
                             point(1), interval_function(FUNCTION_TANH, u0))),
                         u.by);
    return out;
}

/* m = asinh(e^u/2): m' = tanh(m) u', and 0 <= tanh(m)/m <= 1. */
static struct jet1 friction(const struct interval_growth *w, struct interval m,
                            struct growth by)
{
    static const struct interval part = { 0, 1 };

    return (struct jet1){
        number(m), times(w, number(interval_function(FUNCTION_TANH, m)), by),
        times(w, number(part), by)
    };
}

/* asinh(u) is one of the logarithm, or has a slope between 0 and 1. */
static struct jet1 arcsinh(const struct interval_growth *w, struct jet1 u)
{
    static const struct interval part = { 0, 1 };
    const struct interval m = interval_asinh(u.value.all);

    return interval_is_finite(u.rate.c) ? friction(w, m, u.rate)
                                        : function(w, m, part, u);
}

/* False: there is no rule. */
static bool call(const struct interval_growth *w, const struct formula_node *n,
                 struct jet1 *out)
{
    const struct jet1 u = get(w, n->of[0]);

    switch (n->function) {
        case FUNCTION_EXP:
            *out = exponential(w, u);
            return true;
        case FUNCTION_LN:
            *out = logarithm(w, u);
            return true;
        case FUNCTION_POWER:
            *out = power(w, u, get(w, n->of[1]));
            return true;
        case FUNCTION_SQRT:
            *out = power(w, u, constant(point(0.5)));
            return true;
        case FUNCTION_SINH:
            *out = hyperbolic(w, u);
            return true;
        case FUNCTION_ASINH:
            *out = arcsinh(w, u);
            return true;
        case FUNCTION_ASINHEXP:
            *out = friction(w, interval_asinh_exp(u.value.all), u.by);
            return true;
        default:
            return false;
    }
}

static bool make(const struct interval_growth *w, int i, struct jet1 *out)
{
    const struct formula_node *n = &w->g->f->node[i];
    const struct jet1 u = get(w, n->of[0]), v = get(w, n->of[1]);

    if (n->kind == FORMULA_CALL)
        return call(w, n, out);
    *out = n->kind == FORMULA_SUM     ? add(w, u, v)
           : n->kind == FORMULA_TIMES ? product(w, u, v)
                                      : quotient(w, u, v);
    return true;
}

static bool does_move(const struct interval_growth *w, int i)
{
    const struct formula_node *n = &w->g->f->node[i];

    for (int k = 0; k < n->arguments; k++)
        if (w->moves[n->of[k]])
            return true;
    return i == w->variable[0] || i == w->variable[1];
}

/* What it is above what it is where the graph was run. */
static struct interval change_of(const struct interval_growth *w, int i)
{
    const struct formula_node *n = &w->g->f->node[i];
    const int a = n->of[0], b = n->of[1];
    const struct interval u = w->change[a];
    struct interval out = all;

    if (n->kind == FORMULA_CALL) {
        if (n->function == FUNCTION_EXP)
            out =
                interval_times(interval_graph_get(w->g, i), interval_expm1(u));
    } else if (n->kind == FORMULA_SUM) {
        out = interval_add(u, w->change[b]);
    } else if (n->kind == FORMULA_TIMES) {
        out = interval_add(interval_times(u, interval_graph_get(w->g, b)),
                           interval_times(w->value[a].all, w->change[b]));
    } else {
        out = interval_divide(
            interval_less(
                u, interval_times(interval_graph_get(w->g, i), w->change[b])),
            w->value[b].all);
    }
    return out.lo <= out.hi ? out : all;
}

/* What has no bound of its own by what is as large. */
static struct growth better(const struct interval_growth *w, struct growth u,
                            struct growth v)
{
    if (interval_is_finite(u.c))
        return u;
    v.all = interval_both(v.all, u.all);
    return made(w, v);
}

static void keep(struct interval_growth *w, int i, struct jet1 u)
{
    u.by = better(w, u.by, times(w, u.value, u.rate));
    if (!has_zero(u.value))
        u.rate = better(w, u.rate, over(w, u.by, u.value));
    w->value[i] = u.value;
    w->by[i] = u.by;
    w->rate[i] = u.rate;
}

/* A leaf that moves. */
static struct jet1 variable_of(const struct interval_growth *w, int j, int by)
{
    struct jet1 u = { .value = number(w->at[j]), .by = number(point(j == by)) };

    u.value.c = point(0);
    u.value.slope[j] = 1;
    u.rate = over(w, u.by, u.value);
    return u;
}

bool interval_growth_run(struct interval_growth *w,
                         const struct interval_graph *g, const int variable[2],
                         const struct interval offset[2], int by)
{
    w->g = g;
    for (int j = 0; j < 2; j++) {
        w->variable[j] = variable[j];
        w->offset[j] = offset[j];
        w->at[j] = interval_add(interval_graph_get(g, variable[j]), offset[j]);
    }
    for (int k = 0; k < g->nodes; k++) {
        const int i = g->node[k];
        const int leaf = i == variable[0] ? 0 : i == variable[1] ? 1 : -1;
        struct jet1 u = leaf >= 0 ? variable_of(w, leaf, by)
                                  : constant(interval_graph_get(g, i));
        w->moves[i] = does_move(w, i);
        w->change[i] = leaf >= 0 ? offset[leaf] : point(0);
        if (w->moves[i] && leaf < 0) {
            if (!make(w, i, &u))
                return false;
            w->change[i] = change_of(w, i);
            u.value.all = interval_both(
                u.value.all,
                interval_add(interval_graph_get(g, i), w->change[i]));
        }
        keep(w, i, u);
    }
    return true;
}
