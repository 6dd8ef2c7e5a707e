#include "constants.h"

#include <assert.h>
#include <string.h>

#include "quad.h"

#define SCALAR  quad
#define KIND(f) quad_##f
#define FN(f)   f##q
#include "constants_formula.h"

void formula_constants(const struct formula *f,
                       const struct formula_value leaf[], const bool needed[],
                       formula_real least, formula_real value[])
{
    (void) quad_constants(f, leaf, needed, least, value);
}

void formula_again(const struct formula *f, const short node[], int count,
                   formula_real value[])
{
    quad_again(f, node, count, value);
}
