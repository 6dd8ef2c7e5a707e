/* The functions of constants.h, for SCALAR, KIND and FN. */

#include "scalar.h"

/* Leaves are mostly given in the order in which the graph has them, after its
 * first node, 0. */
static SCALAR KIND(leaf_value)(const struct formula_value leaf[], int count,
                               int node, const char *name)
{
    if (node >= 1 && node <= count && strcmp(leaf[node - 1].name, name) == 0)
        return (SCALAR) leaf[node - 1].value;
    while (leaf->name && strcmp(leaf->name, name) != 0)
        leaf++;
    return leaf->name ? (SCALAR) leaf->value : 0;
}

/* Those that every mathematical library has, but for the powers. */
static SCALAR KIND(common)(enum formula_function function, SCALAR u)
{
    switch (function) {
        case FUNCTION_EXP:
            return FN(exp)(u);
        case FUNCTION_LN:
            return FN(log)(u);
        case FUNCTION_SQRT:
            return FN(sqrt)(u);
        case FUNCTION_SIN:
            return FN(sin)(u);
        case FUNCTION_COS:
            return FN(cos)(u);
        case FUNCTION_TAN:
            return FN(tan)(u);
        case FUNCTION_ASIN:
            return FN(asin)(u);
        case FUNCTION_ATAN:
            return FN(atan)(u);
        case FUNCTION_SINH:
            return FN(sinh)(u);
        case FUNCTION_COSH:
            return FN(cosh)(u);
        case FUNCTION_TANH:
            return FN(tanh)(u);
        default:
            assert(function == FUNCTION_ASINH);
            return FN(asinh)(u);
    }
}

static SCALAR KIND(called)(enum formula_function function, SCALAR u, SCALAR w)
{
    switch (function) {
        case FUNCTION_POWER:
            return FN(pow)(u, w);
        case FUNCTION_ASINHEXP:
            return scalar_asinh_exp(u);
        case FUNCTION_LAMBERT:
            return scalar_lambert(u);
        default:
            return KIND(common)(function, u);
    }
}

static SCALAR KIND(node_value)(const struct formula_node *n,
                               const SCALAR value[])
{
    const SCALAR u = value[n->of[0]], w = value[n->of[1]];

    switch (n->kind) {
        case FORMULA_NUMBER:
            return (SCALAR) n->number;
        case FORMULA_SUM:
            return u + w;
        case FORMULA_TIMES:
            return u * w;
        case FORMULA_OVER:
            return u / w;
        default:
            return KIND(called)(n->function, u, w);
    }
}

static void KIND(again)(const struct formula *f, const short node[], int count,
                        SCALAR value[])
{
    for (int i = 0; i < count; i++)
        value[node[i]] = KIND(node_value)(&f->node[node[i]], value);
}

/* Whether value[i] has lost more than eight bits that its arguments had: a sum
 * that cancels, a function that is small where its argument is not, or is
 * steep. */
static bool KIND(loses)(const struct formula_node *n, const SCALAR value[],
                        SCALAR out)
{
    const SCALAR part = (SCALAR) 1 / 256, size = FN(fabs)(out);
    const SCALAR u = FN(fabs)(value[n->of[0]]), w = FN(fabs)(value[n->of[1]]);

    if (n->kind == FORMULA_SUM)
        return size < part * (u > w ? u : w);
    if (n->kind != FORMULA_CALL)
        return false;
    switch (n->function) {
        case FUNCTION_EXP:
        case FUNCTION_LAMBERT:
            return false;
        case FUNCTION_LN:
            return size < part;
        case FUNCTION_ASIN:
            return 1 - u < part * part;
        case FUNCTION_TAN:
            return size < part * u || part * size > 1;
        case FUNCTION_POWER: /* u's rounding w times */
            return part * w > 1;
        default:
            return size < part * u && size > 0;
    }
}

/* False where something that is needed loses digits. */
static bool KIND(constants)(const struct formula *f,
                            const struct formula_value leaf[],
                            const bool needed[], SCALAR least, SCALAR value[])
{
    bool whole = true;
    int count = 0;

    while (leaf[count].name)
        count++;
    for (int i = 0; i < f->nodes; i++) {
        const struct formula_node *n = &f->node[i];
        const bool idle = n->moves || (needed && !needed[i]);
        value[i] = idle ? 0
                   : n->kind == FORMULA_LEAF
                       ? KIND(leaf_value)(leaf, count, i, n->name)
                       : KIND(node_value)(n, value);
        if (least > 0 && n->kind == FORMULA_SUM &&
            FN(fabs)(value[i]) < least * FN(fabs)(value[n->of[0]]))
            value[i] = 0;
        if (least <= 0 && !idle && KIND(loses)(n, value, value[i]))
            whole = false;
    }
    return whole;
}
