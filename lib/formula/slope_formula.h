/* The functions of slope.h, for SCALAR, KIND and FN. */

/* d function/d argument of those with one; w: the function's value. */
static SCALAR KIND(slope_of)(enum formula_function function, SCALAR u, SCALAR w)
{
    switch (function) {
        case FUNCTION_EXP:
            return w;
        case FUNCTION_LN:
            return 1 / u;
        case FUNCTION_SQRT:
            return (SCALAR) 0.5 / w;
        case FUNCTION_SIN:
            return FN(cos)(u);
        case FUNCTION_COS:
            return -FN(sin)(u);
        case FUNCTION_TAN:
            return 1 + w * w;
        case FUNCTION_ASIN:
            return 1 / FN(sqrt)((1 - u) * (1 + u));
        case FUNCTION_ATAN:
            return 1 / (1 + u * u);
        case FUNCTION_SINH:
            return FN(cosh)(u);
        case FUNCTION_COSH:
            return FN(sinh)(u);
        case FUNCTION_TANH:
            return (1 - w) * (1 + w);
        case FUNCTION_ASINH:
            return 1 / FN(hypot)(1, u);
        case FUNCTION_ASINHEXP: /* asinh(e^u/2) */
            return FN(tanh)(w);
        case FUNCTION_LAMBERT: /* W(e^-u): W' = -W/(1 + W) */
            return -w / (1 + w);
        default:
            return (SCALAR) NAN;
    }
}

/* c s, and 0 where s is, whatever c is. */
static SCALAR KIND(slope_by)(SCALAR c, SCALAR s)
{
    return s == 0 ? 0 : c * s;
}

/* du, dw: those of the arguments. */
static SCALAR KIND(slope_at)(const struct formula_node *n, SCALAR here,
                             const SCALAR value[], SCALAR du, SCALAR dw)
{
    const SCALAR u = value[n->of[0]], w = value[n->of[1]];

    switch (n->kind) {
        case FORMULA_NUMBER:
            return 0;
        case FORMULA_SUM:
            return du + dw;
        case FORMULA_TIMES:
            return KIND(slope_by)(w, du) + KIND(slope_by)(u, dw);
        case FORMULA_OVER:
            return KIND(slope_by)(1 / w, du) - KIND(slope_by)(here / w, dw);
        default:
            if (n->function == FUNCTION_POWER)
                return KIND(slope_by)(w * FN(pow)(u, w - 1), du) +
                       KIND(slope_by)(here * FN(log)(u), dw);
            return KIND(slope_by)(KIND(slope_of)(n->function, u, here), du);
    }
}

void KIND(slopes)(const struct formula *f, const short node[], int count,
                  const SCALAR value[], SCALAR slope[])
{
    for (int i = 0; i < count; i++) {
        const struct formula_node *n = &f->node[node[i]];
        slope[node[i]] = KIND(slope_at)(n, value[node[i]], value,
                                        slope[n->of[0]], slope[n->of[1]]);
    }
}
