#include "quad_tape.h"

#define TAPE_SCALAR    quad
#define TAPE_CONSTANT  quad
#define CONSTANT_FN(f) f##q
#define TAPE_KIND(f)   quad_##f
#define SCALAR         quad
#define FN(f)          f##q
#include "number_tape_formula.h"

void quad_tape_field(const struct quad_tape *t, quad X, quad Y, quad rate[2],
                     quad *scale, quad *value)
{
    quad r[TAPE_STEPS + 2], e[2];

    quad_tape_run(t, X, Y, 1, r);
    for (int i = 0; i < 2; i++)
        e[i] = quad_tape_exponent(t, i, r);
    *scale = scalar_larger(e[0], e[1]);
    for (int i = 0; i < 2; i++)
        rate[i] = quad_tape_mantissa(t, i, r) * expq(e[i] - *scale);
    *value = quad_tape_linear(t, &t->value[0], r);
}
