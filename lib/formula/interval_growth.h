/*
 * interval_growth.h -- formulas over boxes of the chart that may have no end:
 * what a node, its derivative by one variable and the logarithm's can be there.
 *
 * With z the variables, a number is e^(p z) c + s z, the powers p and slopes s
 * what the formula shows and c an interval, and it is in an interval `all`,
 * too: v/v is 1, psi/(c + psi) is bounded though v and psi are not, and
 * e^(ln(v)/2) a power.  With u' = (ln |u|)' u either derivative bounds the
 * other; of a sum whose terms differ in size, (ln |u + w|)' = (ln |u|)' + ((ln
 * |w|)' - (ln |u|)') w/(u + w). Rules are identities, rounded outward: what is
 * found holds at every point of the box.  An infinite end says nothing.
 *
 * The box is offsets from the state at which the graph has been run, to many
 * digits; what a number differs by from what it is there has rules of its own,
 * D(u + w) = Du + Dw, D(u w) = w_0 Du + u Dw, D(u/w) = (Du - (u/w)_0 Dw)/w,
 * De^u = e^u_0 (e^Du - 1): of psi - psi_ss near 3e20 it knows the 20 digits
 * that a difference does not.
 */
#pragma once

#include "interval_graph.h"

/* Slopes only without powers. */
struct growth {
    long double power[2], slope[2];
    struct interval c, all;
};

/* By node.  Large. */
struct interval_growth {
    const struct interval_graph *g; /* borrowed */
    int variable[2];                /* leaves */
    struct interval offset[2], at[2];
    bool moves[FORMULA_NODES]; /* depends on them */
    struct growth value[FORMULA_NODES], by[FORMULA_NODES],
        rate[FORMULA_NODES]; /* itself, its derivative, that of its logarithm */
    struct interval change[FORMULA_NODES]; /* D */
};

/* Over the box of offsets, with derivatives by variable `by`.  The graph has
 * been run: its other leaves count.  False where a function has no rule. */
MUST_CHECK bool interval_growth_run(struct interval_growth *w,
                                    const struct interval_graph *g,
                                    const int variable[2],
                                    const struct interval offset[2], int by);
