/*
 * patchwork.h -- cells (cells.h) of a grid from few states of it: rectangles
 * over which the fields, or the base points that tell them, are polynomials
 * (patch.h); the cells between and beside them are found one by one.
 *
 * A rectangle is sampled at 10 x 10 Chebyshev points, or 10 along a side of
 * more than 10 cells and the cells themselves along the other.  Where the bound
 * on a polynomial's error is too wide it is cut, along the sides whose last
 * coefficients say so and into as many parts as they ask for; what the whole
 * has been sampled at tests its parts.
 */
#pragma once

#include "monitor.h"
#include "patch.h"

/* Rows that are best filled at a time. */
enum { PATCHWORK_TILE = 64 };

/* Columns first .. end - 1 of a row: those beside them have no field that is
 * asked for; first = end: none has. */
struct patchwork_span {
    size_t first, end;
};

/* Of a row's n labels (enum fate): fates as of patchwork_source. */
struct patchwork_span patchwork_span_of(const int8_t label[], size_t n,
                                        unsigned fates);

/* Cell centres, absolute chart points in ascending order. */
struct patchwork_grid {
    const double *x, *y; /* borrowed */
    size_t columns, rows;
    const struct patchwork_span *span; /* borrowed, for the plan: of each row */
};

/* How states are found. */
struct patchwork_source {
    /* as cells_find */
    enum status (*find)(const void *ctx, const struct vec2 z[], size_t n,
                        double rtol, unsigned which, struct cell out[]);
    /* the same, about as accurately, with their base points; sample[].z is the
     * caller's */
    enum status (*sample)(const void *ctx, struct patch_sample sample[],
                          size_t n, double rtol, unsigned which);
    struct patch_teller teller;
    /* bits 1u << enum fate: states of others have no field that is asked for,
     * and none is looked at */
    unsigned fates;
    const void *ctx;
};

struct patchwork {
    struct patchwork_grid grid;
    struct patchwork_source source;
    double rtol;
    unsigned which;
    struct patch *patch; /* owned; they do not overlap */
    size_t count, room;
    size_t sampled; /* states */
};

/* For the whole grid.  The monitor (may be NULL) hears of "patches".  The same
 * at any number of threads.  STATUS_NO_MEMORY, STATUS_STOPPED, or what the
 * source fails with: *w is empty. */
MUST_CHECK enum status patchwork_plan(struct patchwork *w,
                                      const struct patchwork_grid *grid,
                                      const struct patchwork_source *source,
                                      double rtol, unsigned which,
                                      const struct monitor *monitor);

/* Rows first .. first + count - 1 into out[count * columns], row by row, as
 * cells_find would, but errors of what is interpolated hold the
 * interpolation's; label: the fates of these cells, as another method tells
 * them; a cell that would get another one is found by itself.  The same bits at
 * any number of threads and in any parts.  *sampled (may be NULL) is increased
 * by the states found.  STATUS_NO_MEMORY, or what the source fails with: out
 * partly filled. */
MUST_CHECK enum status patchwork_rows(const struct patchwork *w, size_t first,
                                      size_t count, const int8_t label[],
                                      struct cell out[], size_t *sampled);

/* A second call is harmless. */
void patchwork_free(struct patchwork *w);
