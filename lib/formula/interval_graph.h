/*
 * interval_graph.h -- what does not change in a graph, enclosed to as many bits
 * as asked for: MPFI's intervals (Revol & Rouillier, Reliable Computing 11
 * (2005) 275), which round outward.  Decimals count as they are written.
 *
 *     interval_graph_init(&g, f, needed, 200);
 *     interval_graph_set(&g, "a", x);     every leaf that is needed
 *     interval_graph_run(&g, &why);       again after each change of a leaf
 *     interval_graph_get(&g, node);
 */
#pragma once

#include <mpfi.h>

#include "interval.h"

struct interval_graph {
    const struct formula *f;    /* borrowed */
    short node[FORMULA_NODES];  /* those that are needed, in order */
    short place[FORMULA_NODES]; /* of a node in value[], or -1 */
    int nodes;
    mpfi_t *value; /* owned */
};

/* Of what is needed what does not move.  STATUS_NO_MEMORY. */
MUST_CHECK enum status interval_graph_init(struct interval_graph *g,
                                           const struct formula *f,
                                           const bool needed[], int bits);
void interval_graph_free(struct interval_graph *g);

/* Where the leaf is needed. */
void interval_graph_set(struct interval_graph *g, const char *leaf,
                        mpfi_srcptr value);

/* STATUS_BAD_ARGUMENT: a function has no rule, or is not defined. */
MUST_CHECK enum status interval_graph_run(struct interval_graph *g,
                                          struct fault *why);

/* Of a node that is needed; the same, rounded outward. */
mpfi_srcptr interval_graph_value(const struct interval_graph *g, int node);
struct interval interval_graph_get(const struct interval_graph *g, int node);

/* A function of an interval of doubles, as far as it has a rule; infinite ends
 * where it is not defined. */
struct interval interval_function(enum formula_function function,
                                  struct interval u);

/* A number that was kept in 113 bits, with all it may have been
 * (interval_decimal). */
void interval_graph_decimal(mpfi_ptr out, formula_real x);

/* Whether sums of long doubles have the 64 bits that all of interval_math.h
 * rests on: the processor can be told to round to 53, and valgrind does. */
bool interval_has_64_bits(void);

/* The numbers of 64 bits around an interval; without these bits all numbers. */
struct interval interval_of_mpfi(mpfi_srcptr u);
