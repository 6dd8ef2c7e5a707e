/*
 * patch.h -- one rectangle of cells, over which fields (cells.h) are
 * polynomials, or the base points (base_point.h) that tell them.
 */
#pragma once

#include "base_point.h"
#include "cells.h"
#include "patch_poly.h"

/* A state that has been looked at; no number is there that it lacks. */
struct patch_sample {
    struct vec2 z;
    struct cell cell;        /* NaN where its base point passes a box */
    struct base_point base;  /* NaN: none */
    double left, left_error; /* v^2 where it arrests, V_star^2 */
};

/* What base points say, for `ctx`. */
struct patch_teller {
    /* The cell at z, its errors as many times as large as the base's; false
     * where it is not to be relied on, too near a boundary or a box. */
    bool (*tell)(const void *ctx, struct vec2 z, const struct base_point *base,
                 unsigned which, struct cell *out);
    /* c's mean friction and its error, of its slip and of v^2 at arrest. */
    void (*friction)(const void *ctx, struct vec2 z, double left,
                     double left_error, struct cell *c);
    /* Whether any between the two may pass a box of arrest. */
    bool (*passes)(const void *ctx, double one, double other);
    const void *ctx;
};

enum { PATCH_BASE_Y, PATCH_BASE_MORE, PATCH_BASES };

struct patch {
    struct patch_side x, y;
    unsigned which, plain; /* bits: fields asked for; those with coef */
    bool has_base;
    int8_t exit_reason; /* of the samples; FATE_UNDECIDED: they differ */
    /* of mean friction: v^2 at arrest; it is told by that and slip */
    struct patch_poly field[CELL_FIELDS], base[PATCH_BASES];
    double late;             /* of its base points, at most */
    double bar[CELL_FIELDS]; /* relative, the largest; NaN where the field does
                                not exist */
};

/* How well polynomials stand for a rectangle. */
struct patch_verdict {
    bool holds; /* well enough */
    /* otherwise: by what factor the last coefficients along each side are too
     * large, and whether there are polynomials at all: if not, 1 along the
     * sides on which samples differ in kind, else 0 */
    double excess_x, excess_y;
    bool is_smooth;
};

/* Its nodes, row by row; how many. */
size_t patch_nodes(const struct patch_side *x, const struct patch_side *y,
                   struct vec2 z[PATCH_NODES]);

/* From what was found at the nodes, and then at some more states, at which it
 * is tested (those on an exact side's cells alone); count <= PATCH_STATES. */
struct patch_verdict patch_fit(struct patch *p, const struct patch_side *x,
                               const struct patch_side *y, unsigned which,
                               double rtol, const struct patch_teller *teller,
                               const struct patch_sample sample[],
                               size_t count);

/* Its cells on rows first .. first + rows - 1 of side y, one row from the next
 * `stride` apart in label and out; those that it cannot tell, or not as well as
 * rtol, or other than labelled have exit_reason FATE_NONE. */
void patch_rows(const struct patch *p, size_t first, size_t rows, size_t stride,
                const int8_t label[], double rtol,
                const struct patch_teller *teller, struct cell out[]);
