#include "slope.h"

#include <math.h>

/* d function/d argument of those with one; w: the function's value. */
static long double slope_of(enum formula_function function, long double u,
                            long double w)
{
    switch (function) {
        case FUNCTION_EXP:
            return w;
        case FUNCTION_LN:
            return 1 / u;
        case FUNCTION_SQRT:
            return 0.5L / w;
        case FUNCTION_SIN:
            return cosl(u);
        case FUNCTION_COS:
            return -sinl(u);
        case FUNCTION_TAN:
            return 1 + w * w;
        case FUNCTION_ASIN:
            return 1 / sqrtl((1 - u) * (1 + u));
        case FUNCTION_ATAN:
            return 1 / (1 + u * u);
        case FUNCTION_SINH:
            return coshl(u);
        case FUNCTION_COSH:
            return sinhl(u);
        case FUNCTION_TANH:
            return (1 - w) * (1 + w);
        case FUNCTION_ASINH:
            return 1 / hypotl(1, u);
        case FUNCTION_ASINHEXP: /* asinh(e^u/2) */
            return tanhl(w);
        case FUNCTION_LAMBERT: /* W(e^-u): W' = -W/(1 + W) */
            return -w / (1 + w);
        default:
            return (long double) NAN;
    }
}

/* c s, and 0 where s is, whatever c is. */
static long double times(long double c, long double s)
{
    return s == 0 ? 0 : c * s;
}

static long double slope_at(const struct formula_node *n, long double here,
                            const long double value[],
                            const long double slope[])
{
    const long double u = value[n->of[0]], w = value[n->of[1]];
    const long double du = slope[n->of[0]], dw = slope[n->of[1]];

    switch (n->kind) {
        case FORMULA_SUM:
            return du + dw;
        case FORMULA_TIMES:
            return times(w, du) + times(u, dw);
        case FORMULA_OVER:
            return times(1 / w, du) - times(here / w, dw);
        default:
            if (n->function == FUNCTION_POWER)
                return times(w * powl(u, w - 1), du) +
                       times(here * logl(u), dw);
            return times(slope_of(n->function, u, here), du);
    }
}

void formula_slopes(const struct formula *f, const long double value[],
                    int leaf, long double slope[])
{
    for (int i = 0; i < f->nodes; i++) {
        const struct formula_node *n = &f->node[i];
        slope[i] = n->kind == FORMULA_NUMBER || n->kind == FORMULA_LEAF
                       ? (long double) (i == leaf)
                       : slope_at(n, value[i], value, slope);
    }
}
