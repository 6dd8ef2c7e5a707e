/*
 * patch.h -- one rectangle of the chart, over which fields (cells.h) are
 * polynomials.
 */
#ifndef STUDY_PATCH_H
#define STUDY_PATCH_H

#include <stdbool.h>

#include "cells.h"

enum {
    PATCH_SIDE = 8, /* Chebyshev points of the first kind along a side */
    PATCH_NODES = PATCH_SIDE * PATCH_SIDE,
    PATCH_TESTS = 8,
    PATCH_STATES = PATCH_NODES + PATCH_TESTS
};

struct patch {
    struct box box; /* absolute */
    unsigned which;
    int8_t exit_reason;
    double coef[CELL_FIELDS][PATCH_SIDE][PATCH_SIDE]; /* [y][x] */
    double bar[CELL_FIELDS]; /* relative; NaN where the field does not exist */
};

/* Its nodes, row by row. */
void patch_nodes(const struct box *box, struct vec2 z[PATCH_NODES]);

/* From what was found at the nodes, and then at test[PATCH_TESTS]; false where
 * fates differ or are undecided, some of the states lack a field, or a bar is
 * wider than rtol. */
bool patch_fit(struct patch *p, const struct box *box, unsigned which,
               double rtol, const struct vec2 test[PATCH_TESTS],
               const struct cell cell[PATCH_STATES]);

/* The cells at (x[i], y), i = 0 .. n - 1, all in the box. */
void patch_row(const struct patch *p, const double x[], size_t n, double y,
               struct cell out[]);

#endif
