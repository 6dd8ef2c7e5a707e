#include "slope.h"

#include <float.h>
#include <math.h>

#include "quad.h"

#define SCALAR  long double
#define KIND(f) formula_long_##f
#define FN(f)   f##l
#include "slope_formula.h"
#undef SCALAR
#undef KIND
#undef FN

void formula_long_roundings(const struct formula *f, const short node[],
                            int count, const long double value[],
                            long double off[])
{
    for (int i = 0; i < count; i++) {
        const struct formula_node *n = &f->node[node[i]];
        const long double here = value[node[i]];
        const bool exact =
            n->kind == FORMULA_NUMBER && n->number == (formula_real) here;
        off[node[i]] = exact ? 0 : LDBL_EPSILON * fabsl(here);
        for (int k = 0; k < 2; k++)
            off[node[i]] += fabsl(formula_long_slope_at(
                n, here, value, k == 0 ? off[n->of[0]] : 0,
                k == 1 ? off[n->of[1]] : 0));
    }
}

#define SCALAR  quad
#define KIND(f) formula_##f
#define FN(f)   f##q
#include "slope_formula.h"
