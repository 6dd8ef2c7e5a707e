#include "quad_tape.h"

#include <assert.h>
#include <string.h>

#define SCALAR quad
#define FN(f)  f##q
#include "scalar.h"

/* ---- constants ----------------------------------------------------------- */

static quad leaf_value(const struct quad_leaf leaf[], const char *name)
{
    while (leaf->name && strcmp(leaf->name, name) != 0)
        leaf++;
    return leaf->name ? leaf->value : 0;
}

static quad called(enum formula_function function, quad u, quad w)
{
    switch (function) {
        case FUNCTION_EXP:
            return expq(u);
        case FUNCTION_LN:
            return logq(u);
        case FUNCTION_SQRT:
            return sqrtq(u);
        case FUNCTION_SINH:
            return sinhq(u);
        case FUNCTION_ASINH:
            return asinhq(u);
        case FUNCTION_ASINHEXP:
            return scalar_asinh_exp(u);
        case FUNCTION_LAMBERT:
            return scalar_lambert(u);
        default:
            assert(function == FUNCTION_POWER);
            return powq(u, w);
    }
}

static quad node_value(const struct formula_node *n, const quad value[],
                       const struct quad_leaf leaf[])
{
    const quad u = value[n->of[0]], w = value[n->of[1]];

    switch (n->kind) {
        case FORMULA_NUMBER:
            return n->number;
        case FORMULA_LEAF:
            return leaf_value(leaf, n->name);
        case FORMULA_SUM:
            return u + w;
        case FORMULA_TIMES:
            return u * w;
        case FORMULA_OVER:
            return u / w;
        default:
            return called(n->function, u, w);
    }
}

static void linear_at(const struct linear *u, const quad value[],
                      struct quad_linear *out)
{
    out->constant = value[u->constant];
    out->terms = u->terms;
    for (int i = 0; i < u->terms; i++) {
        out->reg[i] = u->term[i].reg;
        out->c[i] = value[u->term[i].c];
    }
}

void quad_tape_at(const struct formula *f, const struct tape *t,
                  const struct quad_leaf leaf[], struct quad_tape *out)
{
    quad value[FORMULA_NODES];

    assert(t->steps <= QUAD_STEPS);
    for (int i = 0; i < f->nodes; i++)
        value[i] = f->node[i].moves ? 0 : node_value(&f->node[i], value, leaf);
    out->steps = t->steps;
    for (int i = 0; i < t->steps; i++) {
        out->step[i].kind = t->step[i].kind;
        out->step[i].a = t->step[i].a;
        out->step[i].b = t->step[i].b;
        out->step[i].k = value[t->step[i].k];
        out->step[i].q = t->step[i].kind == STEP_FRICTION
                             ? 4 * expq(-2 * out->step[i].k)
                             : value[t->step[i].q];
        linear_at(&t->step[i].form, value, &out->step[i].form);
    }
    for (int i = 0; i < 2; i++) {
        linear_at(&t->rate[i].mantissa, value, &out->rate[i].mantissa);
        for (int k = 0; k < 2; k++)
            linear_at(&t->rate[i].exponent[k], value,
                      &out->rate[i].exponent[k]);
        out->rate[i].sinh = t->rate[i].sinh;
        out->rate[i].scaled = t->rate[i].scaled;
    }
    linear_at(&t->value[0], value, &out->value);
}

/* ---- steps --------------------------------------------------------------- */

static quad linear(const struct quad_linear *u, const quad r[])
{
    quad sum = u->constant;

    for (int i = 0; i < u->terms; i++)
        sum += u->c[i] * r[u->reg[i]];
    return sum;
}

/* ln of what a growth has grown to */
static quad grown(const struct quad_tape *t, int i, const quad r[])
{
    const int b = t->step[i].b;

    return b >= 0 ? r[b] : t->step[i].q + r[t->step[i].a];
}

/* p (e^u - 1), l = u + ln p */
static quad growth(quad p, quad l, quad u)
{
    return u > 1 ? expq(l) - p : p * scalar_em1(u);
}

/* Step i, each growth and apart times e^-s. */
static quad make(const struct quad_tape *t, int i, quad s, const quad r[])
{
    const quad k = t->step[i].k, q = t->step[i].q;
    const quad u = t->step[i].a >= 0 ? r[t->step[i].a] : 0,
               w = t->step[i].b >= 0 ? r[t->step[i].b] : 0;

    switch (t->step[i].kind) {
        case STEP_GROWTH:
            return growth(s > 0 ? expq(q - s) : k, grown(t, i, r) - s, u);
        case STEP_APART:
            return scalar_difference(k, u - s, w + q - s);
        case STEP_EXP:
            return expq(q + u);
        case STEP_MIXED:
            return scalar_log1p_expm1(k, q, u);
        case STEP_LN1P:
            return log1pq(u / k);
        case STEP_SINH:
            return scalar_sinh(k + u);
        case STEP_FRICTION:
            return scalar_friction(k, q, u);
        case STEP_PRODUCT:
            return u * w;
        case STEP_QUOTIENT:
            return u / (k + w);
        default:
            return linear(&t->step[i].form, r);
    }
}

static bool grows(const struct quad_tape *t, int reg)
{
    return reg >= 2 && (t->step[reg - 2].kind == STEP_GROWTH ||
                        t->step[reg - 2].kind == STEP_APART);
}

/* The s of STEP_SCALED. */
static quad scale_of(const struct quad_tape *t, int i, const quad r[])
{
    const struct quad_linear *form = &t->step[i].form;
    quad s = 0;

    for (int j = 0; j < form->terms; j++) {
        const int g = form->reg[j] - 2;
        if (!grows(t, form->reg[j]))
            continue;
        const quad u = r[t->step[g].a], q = t->step[g].q;
        s = scalar_larger(s, t->step[g].kind == STEP_GROWTH
                                 ? grown(t, g, r)
                                 : scalar_larger(u, r[t->step[g].b] + q));
    }
    return s;
}

static quad scaled(const struct quad_tape *t, int i, const quad r[])
{
    const struct quad_linear *form = &t->step[i].form;
    const quad s = scale_of(t, i, r), less = expq(-s);
    quad sum = form->constant * less;

    for (int j = 0; j < form->terms; j++)
        sum += form->c[j] * (grows(t, form->reg[j])
                                 ? make(t, form->reg[j] - 2, s, r)
                                 : r[form->reg[j]] * less);
    return sum;
}

void quad_tape_field(const struct quad_tape *t, quad X, quad Y, quad rate[2],
                     quad *scale, quad *value)
{
    quad r[QUAD_STEPS + 2] = { X, Y }, e[2];

    for (int i = 0; i < t->steps; i++)
        r[i + 2] =
            t->step[i].kind == STEP_SCALED ? scaled(t, i, r) : make(t, i, 0, r);
    for (int i = 0; i < 2; i++) {
        const int sinh = t->rate[i].sinh, s = t->rate[i].scaled;
        e[i] = linear(&t->rate[i].exponent[sinh >= 0 && r[sinh] < 0], r) +
               (s >= 0 ? scale_of(t, s - 2, r) : 0);
    }
    *scale = scalar_larger(e[0], e[1]);
    for (int i = 0; i < 2; i++)
        rate[i] = linear(&t->rate[i].mantissa, r) * expq(e[i] - *scale);
    *value = linear(&t->value, r);
}
