/*
 * formula.h -- formulas as a graph: numbers, names, + - * /, functions.
 *
 * A node is an index; its arguments have smaller ones, and what is there
 * already is not made again, so that equal formulas are equal indices.  Numbers
 * are folded in 113 bits; 0 + u is u, u - u is 0, exp(ln u) is u.  Everything
 * that is computed from a formula is a formula again: its constants at a
 * point, and its text for another program.
 *
 *     formula_init(f);
 *     int v = formula_leaf(f, "v", FORMULA_POSITIVE_STATE);
 *     parse (parse.h) or build: formula_times(f, v, formula_number(f, 2));
 *     lower (tape.h) to differences from a point, or write (lines.h).
 *
 * A graph that is full goes on with zeros and says so in `full`.
 */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "function.h"

__extension__ typedef __float128 formula_real;

enum {
    FORMULA_NODES = 2048,
    FORMULA_DEFINITIONS = 64,
    FORMULA_NAME = 32,
    FORMULA_WHOLE = 10000 /* whole exponents below it are products */
};

enum formula_kind {
    FORMULA_NUMBER,
    FORMULA_LEAF,
    FORMULA_SUM,
    FORMULA_TIMES,
    FORMULA_OVER,
    FORMULA_CALL
};

/* What a name stands for; positive: > 0 wherever the formula is used, or, for
 * a parameter, perhaps 0. */
enum formula_leaf {
    FORMULA_PARAMETER,
    FORMULA_POSITIVE_PARAMETER,
    FORMULA_STATE,
    FORMULA_POSITIVE_STATE
};

struct formula_node {
    enum formula_kind kind;
    enum formula_leaf leaf;
    enum formula_function function;
    int of[FUNCTION_ARGUMENTS], arguments;
    formula_real number;     /* of a leaf, its value where that is known */
    char name[FORMULA_NAME]; /* of a leaf; of others empty until named */
    bool moves;              /* depends on a state */
    bool positive;           /* > 0 (>= 0 without states) by its form */
    bool natural;            /* positive and rather a product than a sum: its
                                logarithm is the simpler of the two */
    bool known;              /* of a leaf */
    bool exponent; /* of a leaf: a graph of another value may have other nodes,
                      see formula_whole */
};

struct formula {
    struct formula_node node[FORMULA_NODES];
    int nodes;
    struct {
        char name[FORMULA_NAME];
        int node;
    } definition[FORMULA_DEFINITIONS]; /* one node may have several */
    int definitions;
    bool full;
};

void formula_init(struct formula *f);

int formula_number(struct formula *f, formula_real number);
int formula_leaf(struct formula *f, const char *name, enum formula_leaf leaf);

int formula_sum(struct formula *f, int u, int w);
int formula_less(struct formula *f, int u, int w);
int formula_times(struct formula *f, int u, int w);
int formula_over(struct formula *f, int u, int w);

/* As many arguments as the function has. */
int formula_call(struct formula *f, enum formula_function function,
                 const int of[]);
int formula_of(struct formula *f, enum formula_function function, int u);

/* Whether it is this number. */
bool formula_is(const struct formula *f, int u, double number);
/* Says what a leaf of no state is. */
void formula_know(struct formula *f, int leaf, formula_real value);
/* Whether u, of numbers and known leaves, is a whole number |p| <
 * FORMULA_WHOLE: u^p of a whole one is a product for any u. */
bool formula_whole(struct formula *f, int u, int *p);
/* The number c >= 0 or < 0 and the rest of u = c rest. */
formula_real formula_factor(const struct formula *f, int u, int *rest);
/* Adds what sign u has of terms with a plus to part[0], with a minus to
 * part[1]. */
void formula_sort(struct formula *f, int u, formula_real sign, int part[2]);
/* Whether its logarithm keeps all digits wherever it is: of a product, and of
 * the sum of one and what is positive. */
bool formula_has_log(const struct formula *f, int u);

/* u = x out, where every term of u shows the factor x; false where one does
 * not. */
bool formula_take_out(struct formula *f, int u, int x, int *out);

/* From here on `name` is u; constants are written under it, too. */
void formula_define(struct formula *f, const char *name, int u);
/* The leaf or the last definition of this name, -1 if there is none. */
int formula_find(const struct formula *f, const char *name, size_t size);

/* Whether it is a number, a leaf, or one times the other. */
bool formula_is_plain(const struct formula *f, int u);

/* Adds to needed[] all that the needed ones are made of. */
void formula_complete(const struct formula *f, bool needed[]);

/* Writes u under this name, unless u has one or is a number, or the name is
 * too long or another node's (capitals do not count). */
void formula_name(struct formula *f, int u, const char *name);
