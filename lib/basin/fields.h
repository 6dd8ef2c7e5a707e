/*
 * fields.h -- slip, time, friction and peaks (cells.h) over the grid of the
 * basin map, a block of cells at a time: a grid need not fit into memory.
 */
#pragma once

#include "basin_map.h"
#include "fast_cells.h"
#include "patchwork.h"

struct fields {
    const struct basin_map *map; /* borrowed: the grid */
    unsigned which; /* bits of enum cell_field; 0: none asked for */
    double rtol;
    struct fast_cells fast;   /* owned; must not move: of the patches */
    struct patchwork patches; /* owned; of the grid */
};

/* What the products of the map's scene ask for; the map must outlive f, which
 * must not move.  STATUS_NO_MEMORY, STATUS_STOPPED: *f is to be freed. */
MUST_CHECK enum status fields_prepare(struct fields *f,
                                      const struct basin_map *map,
                                      const struct monitor *monitor,
                                      struct fault *why);

/* Rows first .. first + rows - 1 of the grid of the map, cell by
 * cell, by few states of it (patchwork.h); PATCHWORK_TILE rows or more at a
 * time are best.  The monitor hears of "cells" done of the whole grid.
 * Otherwise as fast_cells_find. */
MUST_CHECK enum status fields_find(const struct fields *f, size_t first,
                                   size_t rows, const struct monitor *monitor,
                                   struct cell out[]);

/* The same fields on another grid over the same window, good enough for a
 * picture (TOL_SEEN); row j, counted upward, starts at
 * out[j * columns].  STATUS_NO_MEMORY, STATUS_STOPPED. */
MUST_CHECK enum status fields_raster(const struct fields *f, size_t columns,
                                     size_t rows, const struct monitor *monitor,
                                     struct cell out[]);

/* As good, of n states anywhere, each by itself: absolute chart points with
 * these labels (enum fate).  STATUS_NO_MEMORY, STATUS_STOPPED. */
MUST_CHECK enum status fields_states(const struct fields *f,
                                     const struct vec2 z[],
                                     const int8_t label[], size_t n,
                                     const struct monitor *monitor,
                                     struct cell out[]);

/* A second call is harmless. */
void fields_free(struct fields *f);
