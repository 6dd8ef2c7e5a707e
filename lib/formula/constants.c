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

void formula_again(const struct formula *f, const short changing[], int count,
                   formula_real value[])
{
    for (int i = 0; i < count; i++)
        value[changing[i]] = quad_node_value(&f->node[changing[i]], value);
}

int formula_changing(const struct formula *f, int leaf, const int needed[],
                     int n, short changing[])
{
    bool changes[FORMULA_NODES] = { false }, need[FORMULA_NODES] = { false };
    int count = 0;

    for (int i = 0; i < n; i++)
        need[needed[i]] = true;
    for (int i = f->nodes; i-- > 0;)
        for (int j = 0; need[i] && j < f->node[i].arguments; j++)
            need[f->node[i].of[j]] = true;
    changes[leaf] = need[leaf] = true;
    for (int i = leaf; i < f->nodes; i++) {
        for (int j = 0; j < f->node[i].arguments && !changes[i]; j++)
            changes[i] = changes[f->node[i].of[j]];
        if (changes[i] && need[i])
            changing[count++] = (short) i;
    }
    return count;
}
