/*
 * patchwork.h -- cells (cells.h) of a grid from few states of it: squares where
 * the fields are smooth are interpolated, the others found cell by cell.
 *
 * A square is sampled at 8 x 8 Chebyshev points and at some of its cells; the
 * polynomial of the logarithms (of the values of friction) stands for it where
 * the last coefficients and the misses at these cells, a few times over, and
 * the bars of the samples stay within the accuracy; else it is quartered.
 */
#ifndef STUDY_PATCHWORK_H
#define STUDY_PATCHWORK_H

#include "cells.h"

/* The largest squares, in cells; their rows start at multiples of it. */
enum { PATCHWORK_TILE = 64 };

/* Cell centres, absolute chart points in ascending order, and the fate of each
 * row by row, as another method tells it; no square holds two of them. */
struct patchwork_grid {
    const double *x, *y;
    const int8_t *label;
    size_t columns, rows;
};

/* How states are found: as cells_find. */
struct patchwork_source {
    enum status (*find)(void *ctx, const struct vec2 z[], size_t n, double rtol,
                        unsigned which, struct cell out[]);
    void *ctx;
};

/* All cells, row by row, into out[rows * columns], as cells_find would, but
 * errors of what is interpolated hold the interpolation's.  The same bits at
 * any number of threads.  *sampled (may be NULL): states found.
 * STATUS_NO_MEMORY, or what the source fails with: out partly filled. */
MUST_CHECK enum status patchwork_fill(const struct patchwork_grid *g,
                                      const struct patchwork_source *source,
                                      double rtol, unsigned which,
                                      struct cell out[], size_t *sampled);

#endif
