#include "constants.h"

#include <assert.h>
#include <string.h>

#include "quad.h"

#define SCALAR  quad
#define KIND(f) quad_##f
#define FN(f)   f##q
#include "constants_formula.h"

void formula_constants(const struct formula *f,
                       const struct formula_value leaf[], formula_real least,
                       formula_real value[])
{
    (void) quad_constants(f, leaf, least, value);
}

int formula_changing(const struct formula *f, int leaf, short changing[])
{
    bool changes[FORMULA_NODES] = { false };
    int n = 0;

    changes[leaf] = true;
    for (int i = leaf; i < f->nodes; i++) {
        for (int j = 0; j < f->node[i].arguments && !changes[i]; j++)
            changes[i] = changes[f->node[i].of[j]];
        if (changes[i])
            changing[n++] = (short) i;
    }
    return n;
}
