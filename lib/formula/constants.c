#include "constants.h"

#include <assert.h>
#include <string.h>

#include "quad.h"

#define SCALAR quad
#define FN(f)  f##q
#include "scalar.h"

static quad leaf_value(const struct formula_value leaf[], const char *name)
{
    while (leaf->name && strcmp(leaf->name, name) != 0)
        leaf++;
    return leaf->name ? leaf->value : 0;
}

/* Those that every mathematical library has, but for the powers. */
static quad common(enum formula_function function, quad u)
{
    switch (function) {
        case FUNCTION_EXP:
            return expq(u);
        case FUNCTION_LN:
            return logq(u);
        case FUNCTION_SQRT:
            return sqrtq(u);
        case FUNCTION_SIN:
            return sinq(u);
        case FUNCTION_COS:
            return cosq(u);
        case FUNCTION_TAN:
            return tanq(u);
        case FUNCTION_ASIN:
            return asinq(u);
        case FUNCTION_ATAN:
            return atanq(u);
        case FUNCTION_SINH:
            return sinhq(u);
        case FUNCTION_COSH:
            return coshq(u);
        case FUNCTION_TANH:
            return tanhq(u);
        default:
            assert(function == FUNCTION_ASINH);
            return asinhq(u);
    }
}

static quad called(enum formula_function function, quad u, quad w)
{
    switch (function) {
        case FUNCTION_POWER:
            return powq(u, w);
        case FUNCTION_ASINHEXP:
            return scalar_asinh_exp(u);
        case FUNCTION_LAMBERT:
            return scalar_lambert(u);
        default:
            return common(function, u);
    }
}

static quad node_value(const struct formula_node *n, const quad value[],
                       const struct formula_value leaf[])
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

void formula_constants(const struct formula *f,
                       const struct formula_value leaf[], formula_real value[])
{
    for (int i = 0; i < f->nodes; i++)
        value[i] = f->node[i].moves ? 0 : node_value(&f->node[i], value, leaf);
}
