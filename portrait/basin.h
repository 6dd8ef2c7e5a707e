/*
 * basin.h -- which fate every cell of a grid meets.  In the plane separatrices
 * are the boundaries of basins: rows of the grid are cut by them, and whatever
 * lies between two of them is filled.  Cost grows with rows, not cells.
 */
#pragma once

#include "region.h"

/* Cell centres in absolute chart coordinates, both ascending; borrowed. */
struct basin_grid {
    const double *x, *y;
    size_t columns, rows;
};

struct basin {
    const struct regions *regions; /* borrowed */
    struct basin_grid grid;
    size_t *cut;   /* owned; rows * regions->most: in each row the first column
                      right of each strand */
    size_t *doubt; /* owned; rows * strands * 2: the columns from the first to
                      before the second that may lie on it (separatrix_near) */
};

/* Cuts the rows, in parallel, the same at any number of threads.
 * STATUS_BAD_ARGUMENT: no cells; STATUS_NO_MEMORY.  On error *b is empty. */
MUST_CHECK enum status basin_init(struct basin *b,
                                  const struct regions *regions,
                                  const struct basin_grid *grid);

/* The labels of the regions, of rows first .. first + count - 1 into
 * out[count * columns], row after row; REGION_UNLABELLED where a cell may lie
 * on a separatrix; in parallel. */
void basin_fill(const struct basin *b, size_t first, size_t count,
                int8_t out[]);

/* Whether a cell may lie on a separatrix: then it has no label. */
bool basin_is_near(const struct basin *b, size_t row, size_t column);

/* A second call is harmless. */
void basin_free(struct basin *b);
