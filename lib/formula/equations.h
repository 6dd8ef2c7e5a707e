/*
 * equations.h -- where the rates of a plane vanish, as equations in the chart.
 *
 * The chart of a state that is > 0 is its logarithm.  Factors that are > 0 are
 * dropped; sinh u = 0 and its like become u = 0, u^n = 0 becomes u = 0,
 * f(u) = c of a constant c becomes u = f^-1(c), and a sum of terms that are
 * > 0 or < 0, p - q = 0, becomes ln p - ln q = 0: nothing then overflows or
 * explodes however wide the window is.  Denominators that may be 0 are
 * multiplied out.  Wherever the rates are defined, the equations vanish where
 * the rates do, and nowhere else.
 */
#pragma once

#include "formula.h"

struct equations {
    struct formula graph;
    int variable[2];                   /* leaves: the chart */
    int equation[2];                   /* = 0 */
    int rate[2];                       /* of the chart */
    formula_real value[FORMULA_NODES]; /* of the other leaves */
};

/* Of two rates of a graph whose states are two leaves; value[]: of its other
 * leaves, by node.  False: there is no room. */
bool equations_make(struct equations *e, const struct formula *f,
                    const int state[2], const int rate[2],
                    const formula_real value[]);
