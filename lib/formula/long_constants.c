#include <assert.h>
#include <math.h>
#include <string.h>

#include "constants.h"

#define SCALAR  long double
#define KIND(f) long_##f
#define FN(f)   f##l
#include "constants_formula.h"

void formula_long_constants(const struct formula *f,
                            const struct formula_value leaf[],
                            long double value[])
{
    long_constants(f, leaf, 0, value);
}
