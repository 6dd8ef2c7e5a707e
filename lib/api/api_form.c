/* Derivatives go forward through the terms (dual numbers); series by the
 * recurrences of Moore 1966, as in jet.h. */
#include "api_form.h"

#include <math.h>

/* ---- building ------------------------------------------------------------ */

static slipway_term add(struct slipway_form *f, struct form_term term)
{
    if (f->terms == FORM_TERMS) {
        f->failed = true;
        return 0;
    }
    f->term[f->terms] = term;
    return f->terms++;
}

static bool is_term(const struct slipway_form *f, slipway_term t)
{
    return t >= 0 && t < f->terms;
}

slipway_term slipway_constant(slipway_form *form, double value)
{
    form->failed = form->failed || !isfinite(value);
    return add(form, (struct form_term){ FORM_CONSTANT, 0, 0, value });
}

slipway_term slipway_operate(slipway_form *form, slipway_operation operation,
                             slipway_term a, slipway_term b)
{
    const bool known =
        operation >= SLIPWAY_OP_ADD && operation <= SLIPWAY_OP_COS;

    if (!known || !is_term(form, a) || !is_term(form, b)) {
        form->failed = true;
        return 0;
    }
    return add(form, (struct form_term){ (int) operation, a, b, 0.0 });
}

enum status form_build(struct slipway_form *f, slipway_rates *rates, void *ctx)
{
    *f = (struct slipway_form){ .rate = { -1, -1 } };
    const slipway_term x =
        add(f, (struct form_term){ FORM_COORDINATE, 0, 0, 0 });
    const slipway_term y =
        add(f, (struct form_term){ FORM_COORDINATE, 1, 0, 0 });
    rates(ctx, f, x, y, f->rate);
    return f->failed || !is_term(f, f->rate[0]) || !is_term(f, f->rate[1])
               ? STATUS_BAD_ARGUMENT
               : STATUS_OK;
}

/* ---- numbers ------------------------------------------------------------- */

/* A value with its derivatives by x and y. */
struct dual {
    double value;
    struct vec2 slope;
};

/* p grad u + q grad v */
static struct vec2 blend(double p, const struct dual *u, double q,
                         const struct dual *v)
{
    return vec2_add(vec2_scale(p, u->slope), vec2_scale(q, v->slope));
}

static struct dual chain(double value, double derivative, const struct dual *u)
{
    return (struct dual){ value, vec2_scale(derivative, u->slope) };
}

static struct dual operate(int op, const struct dual *u, const struct dual *v)
{
    const double a = u->value, b = v->value;

    switch (op) {
        case SLIPWAY_OP_ADD:
            return (struct dual){ a + b, blend(1, u, 1, v) };
        case SLIPWAY_OP_SUB:
            return (struct dual){ a - b, blend(1, u, -1, v) };
        case SLIPWAY_OP_MUL:
            return (struct dual){ a * b, blend(b, u, a, v) };
        case SLIPWAY_OP_DIV:
            return (struct dual){ a / b, blend(1 / b, u, -a / (b * b), v) };
        case SLIPWAY_OP_EXP:
            return chain(exp(a), exp(a), u);
        case SLIPWAY_OP_LOG:
            return chain(log(a), 1 / a, u);
        case SLIPWAY_OP_SQRT:
            return chain(sqrt(a), 0.5 / sqrt(a), u);
        case SLIPWAY_OP_SIN:
            return chain(sin(a), cos(a), u);
        default:
            return chain(cos(a), -sin(a), u);
    }
}

struct vec2 form_rates(const struct slipway_form *f, struct vec2 z,
                       struct mat2 *slope)
{
    struct dual at[FORM_TERMS] = { { z.x, { 1.0, 0.0 } },
                                   { z.y, { 0.0, 1.0 } } };

    for (int i = 2; i < f->terms; i++) {
        const struct form_term *t = &f->term[i];
        at[i] = t->op == FORM_CONSTANT ? (struct dual){ t->value, { 0.0, 0.0 } }
                                       : operate(t->op, &at[t->a], &at[t->b]);
    }
    const struct dual *p = &at[f->rate[0]], *q = &at[f->rate[1]];
    if (slope)
        *slope =
            (struct mat2){ p->slope.x, p->slope.y, q->slope.x, q->slope.y };
    return (struct vec2){ p->value, q->value };
}

/* ---- series -------------------------------------------------------------- */

typedef double real_function(double);

static jet_pair first(real_function *g, jet_pair u)
{
    return (jet_pair){ g(u[0]), g(u[1]) };
}

/* exp, log, sqrt, sin or cos of u; du[k] = k u[k]. */
static const jet_pair *function_jet(int op, struct jet_work *w, size_t k,
                                    const jet_pair u[])
{
    jet_pair *g = jet_slot(w), *h = jet_slot(w), *du = jet_slot(w);

    du[k] = jet_number[k] * u[k];
    switch (op) {
        case SLIPWAY_OP_EXP:
            g[k] = k == 0 ? first(exp, u[0]) : jet_chain(w, k, u, du, g);
            return g;
        case SLIPWAY_OP_LOG: /* u g' = u' */
            g[k] = k == 0 ? first(log, u[0])
                          : (u[k] - jet_sum(k - 1, h + 1, u + k - 1) *
                                        jet_inverse[k]) /
                                u[0];
            h[k] = jet_number[k] * g[k];
            return g;
        case SLIPWAY_OP_SQRT: /* g g = u */
            g[k] = k == 0 ? first(sqrt, u[0])
                          : (u[k] - jet_sum(k - 1, g + 1, g + k - 1)) /
                                (2.0 * g[0]);
            return g;
        default:
            g[k] = k == 0 ? first(sin, u[0]) : jet_chain(w, k, u, du, h);
            h[k] = k == 0 ? first(cos, u[0]) : -jet_chain(w, k, u, du, g);
            return op == SLIPWAY_OP_SIN ? g : h;
    }
}

static const jet_pair *operate_jet(int op, struct jet_work *w, size_t k,
                                   const jet_pair u[], const jet_pair v[])
{
    if (op > SLIPWAY_OP_DIV)
        return function_jet(op, w, k, u);
    jet_pair *g = jet_slot(w);
    g[k] = op == SLIPWAY_OP_ADD   ? u[k] + v[k]
           : op == SLIPWAY_OP_SUB ? u[k] - v[k]
           : op == SLIPWAY_OP_MUL ? jet_product(k, u, v)
                                  : jet_quotient(k, u, v, g);
    return g;
}

static const jet_pair *constant_jet(struct jet_work *w, size_t k, double value)
{
    jet_pair *g = jet_slot(w);

    g[k] = JET_PAIR(k == 0 ? value : 0.0);
    return g;
}

void form_jet(const struct slipway_form *f, struct jet_work *w, size_t k,
              const jet_pair x[], const jet_pair y[], const jet_pair *rate[2])
{
    const jet_pair *at[FORM_TERMS] = { x, y };

    for (int i = 2; i < f->terms; i++) {
        const struct form_term *t = &f->term[i];
        at[i] = t->op == FORM_CONSTANT
                    ? constant_jet(w, k, t->value)
                    : operate_jet(t->op, w, k, at[t->a], at[t->b]);
    }
    rate[0] = at[f->rate[0]];
    rate[1] = at[f->rate[1]];
}
