/*
 * slope.h -- how what a graph computes changes with one of its leaves, in long
 * double: no differences are taken, and nothing is left out.
 */
#ifndef FORMULA_SLOPE_H
#define FORMULA_SLOPE_H

#include "formula.h"

/* slope[0 .. f->nodes - 1] = d node/d leaf; value[]: of the nodes, as of
 * formula_long_constants; no node may move. */
void formula_slopes(const struct formula *f, const long double value[],
                    int leaf, long double slope[]);

#endif
