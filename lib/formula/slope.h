/*
 * slope.h -- how what a graph computes changes with one of its leaves: no
 * differences are taken, and nothing is left out.
 */
#ifndef FORMULA_SLOPE_H
#define FORMULA_SLOPE_H

#include "formula.h"

/* slope[0 .. f->nodes - 1] = d node/d leaf; value[]: of the nodes, as of
 * formula_constants; no node may move. */
void formula_slopes(const struct formula *f, const formula_real value[],
                    int leaf, formula_real slope[]);
void formula_long_slopes(const struct formula *f, const long double value[],
                         int leaf, long double slope[]);

/* Of changing[] only, as of formula_changing without its leaf; slope[] is 1 at
 * the leaf, 0 at all that does not change. */
void formula_slopes_again(const struct formula *f, const short changing[],
                          int count, const formula_real value[],
                          formula_real slope[]);
void formula_long_slopes_again(const struct formula *f, const short changing[],
                               int count, const long double value[],
                               long double slope[]);

#endif
