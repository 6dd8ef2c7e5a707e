/*
 * lower.h -- the linear forms of nodes, for tape.c.
 */
#pragma once

#include "linear.h"

enum { LOWER_FORMS = 600 };

struct lowering {
    struct forms s;
    const struct plane_formulas *p;
    struct linear form[LOWER_FORMS];
    int forms;
    /* by node: places in form[] plus one of it and of its logarithm, and its
     * value at the anchor plus one; 0: not yet */
    short plain[FORMULA_NODES], whole[FORMULA_NODES], log[FORMULA_NODES],
        value[FORMULA_NODES];
    /* by node: 2, the constant of its plain form is not its value at the
     * anchor; 1, it is; 0, not known yet */
    char away[FORMULA_NODES];
};

/* Nothing is made yet, nor any step of t; borrows all three. */
void lower_start(struct lowering *L, struct formula *f, struct tape *t,
                 const struct plane_formulas *p);

/* Of a node, and of its logarithm. */
struct linear lower_plain(struct lowering *L, int i);
struct linear lower_log(struct lowering *L, int i);
/* Of a node that is 0 at the anchor: so are all its registers. */
struct linear lower_zero(struct lowering *L, int i);

/* Whether node i is a difference of sums of products, part[0] less part[1]: one
 * step then, STEP_APART, and not the sum of its terms.  zero: it is 0 at the
 * anchor, and one part may be a constant. */
bool lower_apart(struct lowering *L, int i, bool zero, int part[2]);
/* The sum of its terms. */
struct linear lower_both(struct lowering *L, int i);
