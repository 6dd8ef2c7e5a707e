#include <assert.h>
#include <math.h>
#include <string.h>

#include "constants.h"

#define SCALAR  long double
#define KIND(f) long_##f
#define FN(f)   f##l
#include "constants_formula.h"

bool formula_long_constants(const struct formula *f,
                            const struct formula_value leaf[],
                            const bool needed[], long double value[])
{
    return long_constants(f, leaf, needed, 0x1p-8L, NULL, value);
}

void formula_long_again(const struct formula *f, const short node[], int count,
                        long double value[])
{
    long_again(f, node, count, value);
}
