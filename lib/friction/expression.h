/*
 * expression.h -- formulas as trees, built by calls and written as text such
 * as "(1 + r)/(r + exp(lnv0))".
 *
 * A tape owns the nodes of many expressions; a node made from others comes
 * after them, and what is there already is not made again.  Plain numbers are
 * folded: 0 + u is u, 1 * u is u.  A node that has been given a name stands in
 * others by this name.
 */
#ifndef FRICTION_EXPRESSION_H
#define FRICTION_EXPRESSION_H

#include <stdbool.h>
#include <stddef.h>

enum { TAPE_NODES = 400, TAPE_ARGUMENTS = 4, TAPE_NAME = 12 };

enum node_kind {
    NODE_NUMBER,
    NODE_LEAF,  /* a name */
    NODE_SUM,   /* u + w */
    NODE_LESS,  /* u - w */
    NODE_TIMES, /* u * w */
    NODE_OVER,  /* u / w */
    NODE_MINUS, /* -u */
    NODE_CALL   /* a function of up to TAPE_ARGUMENTS */
};

struct node {
    enum node_kind kind;
    double number;             /* of a number */
    const char *function;      /* of a call; static */
    char name[TAPE_NAME];      /* of a leaf; of others empty until named */
    bool moves;                /* depends on a leaf that does */
    size_t of[TAPE_ARGUMENTS]; /* arguments, all before this node */
    size_t arguments;
    size_t uses; /* as an argument of nodes, or as a result */
};

struct tape {
    struct node node[TAPE_NODES];
    size_t nodes;
};

/* A node of a tape, or a number that is on none yet (tape is NULL). */
struct expression {
    struct tape *tape; /* borrowed */
    size_t node;
    double number;
    const char *hint; /* the name it would like; static, may be NULL */
};

struct expression expression_number(double number);

/* A leaf; `moves`: it is no constant of the problem. */
struct expression expression_leaf(struct tape *t, const char *name, bool moves);

struct expression expression_sum(struct expression u, struct expression w);
struct expression expression_less(struct expression u, struct expression w);
struct expression expression_times(struct expression u, struct expression w);
struct expression expression_over(struct expression u, struct expression w);

/* f(u, ...): at least one argument is on a tape, the rest may be numbers. */
struct expression expression_call(const char *function,
                                  const struct expression of[],
                                  size_t arguments);

/* Names u's node, at most TAPE_NAME - 1 letters; what is a number, a leaf or
 * has a name stays as it is. */
void expression_name(struct expression u, const char *name);

/* Counts the uses of every node for `results` and what they need. */
void expression_count(const struct expression results[], size_t count);

/* The text of node i, below its own name, in `text`; false where `size` is too
 * small. */
bool expression_write(const struct tape *t, size_t i, char *text, size_t size);

#endif
