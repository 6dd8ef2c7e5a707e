#include "slope.h"

#include <math.h>

#include "quad.h"

#define SCALAR  long double
#define KIND(f) long_##f
#define FN(f)   f##l
#include "slope_formula.h"
#undef SCALAR
#undef KIND
#undef FN

#define SCALAR  quad
#define KIND(f) quad_##f
#define FN(f)   f##q
#include "slope_formula.h"

void formula_long_slopes(const struct formula *f, const long double value[],
                         int leaf, long double slope[])
{
    long_slopes(f, value, leaf, slope);
}

void formula_slopes(const struct formula *f, const formula_real value[],
                    int leaf, formula_real slope[])
{
    quad_slopes(f, value, leaf, slope);
}

void formula_long_slopes_again(const struct formula *f, const short changing[],
                               int count, const long double value[],
                               long double slope[])
{
    long_slopes_again(f, changing, count, value, slope);
}

void formula_slopes_again(const struct formula *f, const short changing[],
                          int count, const formula_real value[],
                          formula_real slope[])
{
    quad_slopes_again(f, changing, count, value, slope);
}
