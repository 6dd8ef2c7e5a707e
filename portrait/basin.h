/*
 * basin.h -- which fate every cell of a grid meets.  In the plane separatrices
 * are the boundaries of basins: rows of the grid are cut by them, whatever
 * lies between two of them is filled, and each region is labelled by one
 * forward integration, never by assumption.  Cost grows with rows, not cells.
 *
 *     struct basin b;
 *     basin_init(&b, &separatrix, &grid);
 *     basin_label(&b, fate, ctx);
 *     basin_fill(&b, 0, grid.rows, labels);
 *     basin_free(&b);
 *
 * Between the ends of strands their order along a row does not change, for
 * stable manifolds do not cross: a `band` of rows, in which `regions` are
 * counted from the left.
 */
#ifndef PORTRAIT_BASIN_H
#define PORTRAIT_BASIN_H

#include <stdint.h>

#include "separatrix.h"

/* Cell centres in absolute chart coordinates, both ascending; borrowed. */
struct basin_grid {
    const double *x, *y;
    size_t columns, rows;
    struct box window; /* all of the cells, centres and edges */
};

struct basin_region {
    bool used;        /* some cell of the grid or part of the window is in it */
    struct vec2 seed; /* absolute: in the middle of its longest row */
    size_t cells;     /* in that row */
    int8_t label;
};

struct basin_band {
    double lo, hi;         /* rows lo <= y < hi */
    size_t strands, first; /* regions first .. first + strands */
};

struct basin {
    const struct separatrix *separatrix; /* borrowed; along y */
    struct basin_grid grid;
    struct basin_band *band; /* owned */
    size_t bands;
    struct basin_region *region; /* owned */
    size_t regions;
    size_t *cut; /* owned; rows * cuts: in row j the first column to the right
                    of each strand, ascending */
    size_t cuts; /* most strands in a row */
};

/* Finds bands, cuts and seeds; runs in parallel, the result does not depend on
 * the number of threads.  STATUS_BAD_ARGUMENT: an empty grid or a separatrix
 * not along y; STATUS_NO_MEMORY.  On error *b is empty. */
MUST_CHECK enum status basin_init(struct basin *b,
                                  const struct separatrix *separatrix,
                                  const struct basin_grid *grid);

/* The label of the forward orbit from z. */
typedef enum status basin_fate(const void *ctx, struct vec2 z, int8_t *label);

/* Asks for the fate of each used region's seed; its errors are passed on. */
MUST_CHECK enum status basin_label(struct basin *b, basin_fate *fate,
                                   const void *ctx);

/* Region of cell (row, column). */
const struct basin_region *basin_at(const struct basin *b, size_t row,
                                    size_t column);

/* Labels of rows first .. first + count - 1 into out[count * columns], row
 * after row; parallel. */
void basin_fill(const struct basin *b, size_t first, size_t count,
                int8_t out[]);

/* A second call is harmless. */
void basin_free(struct basin *b);

#endif
