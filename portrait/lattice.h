/* lattice.h -- the signs of a field's components on a grid of the window, and
 * the zeros between neighbours. */
#pragma once

#include "trace.h"

/* Nodes in u coordinates of zero.h, even in the chart and, where that is not
 * the same, also in the drawing; ascending from 0 to 1. */
struct lattice {
    double *node[2]; /* owned; along x, along y */
    size_t count[2];
    signed char *sign[2]; /* owned; of direction.x, .y at node [0][i], [1][j]
                             as [i + j count[0]]; 0: NaN */
};

/* Evaluates the field at every node.  STATUS_NO_MEMORY: *l is empty. */
MUST_CHECK enum status lattice_init(struct lattice *l,
                                    const struct planar *system,
                                    const struct window *window, size_t cells);

/* One seed for each change of sign of component q->which between neighbours,
 * those on the window's edge first: *seed is owned by the caller.
 * STATUS_NO_MEMORY: *seed is NULL. */
MUST_CHECK enum status lattice_seeds(const struct lattice *l, struct zero *q,
                                     struct seed **seed, size_t *count);

/* A second call is harmless. */
void lattice_free(struct lattice *l);
