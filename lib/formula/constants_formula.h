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

/* The w of ln(1 + w), or NULL. */
static const SCALAR *KIND(beyond_one)(const struct formula *f,
                                      const struct formula_node *n,
                                      const SCALAR value[])
{
    const struct formula_node *sum = &f->node[n->of[0]];

    return n->kind == FORMULA_CALL && n->function == FUNCTION_LN &&
                   sum->kind == FORMULA_SUM && value[sum->of[0]] == 1
               ? &value[sum->of[1]]
               : NULL;
}

static SCALAR KIND(node_value)(const struct formula *f,
                               const struct formula_node *n,
                               const SCALAR value[])
{
    const SCALAR *beyond = KIND(beyond_one)(f, n, value);
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
            return beyond ? FN(log1p)(*beyond)
                          : KIND(called)(n->function, u, w);
    }
}

static void KIND(again)(const struct formula *f, const short node[], int count,
                        SCALAR value[])
{
    for (int i = 0; i < count; i++)
        value[node[i]] = KIND(node_value)(f, &f->node[node[i]], value);
}

/* Whether `out` has only `part` of its arguments' digits, or less: a sum that
 * cancels, a function that is small where its argument is not, or is steep. */
static bool KIND(loses)(const struct formula *f, const struct formula_node *n,
                        const SCALAR value[], SCALAR out, SCALAR part)
{
    const SCALAR size = FN(fabs)(out);
    const SCALAR u = FN(fabs)(value[n->of[0]]), w = FN(fabs)(value[n->of[1]]);

    if (n->kind == FORMULA_SUM)
        return size < part * (u > w ? u : w);
    if (n->kind != FORMULA_CALL)
        return false;
    switch (n->function) {
        case FUNCTION_SIN:
        case FUNCTION_COS:
            return size < part * u && size > 0;
        case FUNCTION_LN:
            return size < part && !KIND(beyond_one)(f, n, value);
        case FUNCTION_ASIN:
            return 1 - u < part * part;
        case FUNCTION_TAN:
            return size < part * u || part * size > 1;
        case FUNCTION_POWER: /* u's rounding w times */
            return part * w > 1;
        default:
            return false;
    }
}

typedef SCALAR KIND(mender)(const struct formula *f,
                            const struct formula_value leaf[], int node,
                            const SCALAR value[]);

/* What is needed and loses digits is mended; without a mender that ends it. */
static bool KIND(constants)(const struct formula *f,
                            const struct formula_value leaf[],
                            const bool needed[], SCALAR part,
                            KIND(mender) * mend, SCALAR value[])
{
    int count = 0;

    while (leaf[count].name)
        count++;
    for (int i = 0; i < f->nodes; i++) {
        const struct formula_node *n = &f->node[i];
        const bool idle = n->moves || (needed && !needed[i]);
        value[i] = idle ? 0
                   : n->kind == FORMULA_LEAF
                       ? KIND(leaf_value)(leaf, count, i, n->name)
                       : KIND(node_value)(f, n, value);
        if (idle || !KIND(loses)(f, n, value, value[i], part))
            continue;
        if (mend == NULL)
            return false;
        value[i] = mend(f, leaf, i, value);
    }
    return true;
}
