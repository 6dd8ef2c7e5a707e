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
