/*
 * slope.h -- how what a graph computes changes with one of its leaves: no
 * differences are taken, and nothing is left out.
 */
#pragma once

#include "formula.h"

/* slope[i] = d node i/d leaf of some nodes, no leaves among them; slope[] is
 * there for leaves and for what else they are made of, value[] for all. */
void formula_slopes(const struct formula *f, const short node[], int count,
                    const formula_real value[], formula_real slope[]);
void formula_long_slopes(const struct formula *f, const short node[], int count,
                         const long double value[], long double slope[]);

/* How far value[i] is off, to first order, if each operation is right to one
 * unit in the last place:
 *
 *     off[i] = LDBL_EPSILON |value[i]| + |d i/d u| off[u] + |d i/d w| off[w],
 *
 * u and w its arguments; of a number that is whole 0, for u^3 of u < 0 has no
 * slope by the exponent; off[] is there for leaves and for what else they are
 * made of. */
void formula_long_roundings(const struct formula *f, const short node[],
                            int count, const long double value[],
                            long double off[]);
