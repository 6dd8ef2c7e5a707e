/*
 * constants.h -- what does not change in a graph, as numbers.
 */
#pragma once

#include "formula.h"

/* A leaf and what it is; of an array the last has no name. */
struct formula_value {
    const char *name;
    formula_real value;
};

/* By node: value[0 .. f->nodes - 1]; 0 for those that change with the state,
 * are not needed (NULL: all are), and for leaves that are not given. */
void formula_constants(const struct formula *f,
                       const struct formula_value leaf[], const bool needed[],
                       formula_real value[]);
/* To all digits of a long double, leaves being taken as told: what loses 40
 * bits or more is enclosed in 320.  A sum of leaves that this does not tell
 * from 0, and that is below 2^-90 of its first term, is 0. */
void formula_exact_constants(const struct formula *f,
                             const struct formula_value leaf[],
                             const bool needed[], formula_real value[]);
/* Faster.  False where a needed one has lost more than eight of the eleven bits
 * that a long double has beyond a double. */
bool formula_long_constants(const struct formula *f,
                            const struct formula_value leaf[],
                            const bool needed[], long double value[]);

/* Some nodes again, no leaves among them, of the others' values. */
void formula_again(const struct formula *f, const short node[], int count,
                   formula_real value[]);
void formula_long_again(const struct formula *f, const short node[], int count,
                        long double value[]);
