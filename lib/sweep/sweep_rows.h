/*
 * sweep_rows.h -- the points of a sweep, a row of one length each: where it is,
 * x[2]; where its layers are in the side file; value and error (and
 * conditioning) of every entry of every column; a code for every entry.  A row
 * is the same bytes in memory and in the side file.
 */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "status.h"

struct sweep_rows {
    size_t entries;
    size_t reals; /* of an entry: 2, with conditioning 3 */
    size_t width; /* of a row, in doubles */
    double *at;   /* owned; rows one after another */
    size_t count, room;
};

/* No rows yet. */
struct sweep_rows sweep_rows_of(size_t entries, bool conditioning);

/* Appends `count` rows of zeros; STATUS_NO_MEMORY leaves *r as it was. */
MUST_CHECK enum status sweep_rows_add(struct sweep_rows *r, size_t count);

static inline double *sweep_rows_row(const struct sweep_rows *r, size_t i)
{
    return r->at + i * r->width;
}

/* Its x[2]. */
static inline double *sweep_rows_x(const struct sweep_rows *r, size_t i)
{
    return sweep_rows_row(r, i);
}

/* Bytes from the start of the side file, a whole number. */
static inline double *sweep_rows_place(const struct sweep_rows *r, size_t i)
{
    return sweep_rows_row(r, i) + 2;
}

/* Of an entry value, error[, conditioning]. */
static inline double *sweep_rows_real(const struct sweep_rows *r, size_t i,
                                      size_t entry)
{
    return sweep_rows_row(r, i) + 3 + entry * r->reals;
}

static inline int8_t *sweep_rows_code(const struct sweep_rows *r, size_t i,
                                      size_t entry)
{
    return (int8_t *) sweep_rows_real(r, i, r->entries) + entry;
}

/* Ascending in x[0], then x[1]. */
void sweep_rows_sort(struct sweep_rows *r);

/* The row at exactly x among rows in that order; r->count if there is none. */
size_t sweep_rows_find(const struct sweep_rows *r, const double x[2]);

/* A second call is harmless. */
void sweep_rows_free(struct sweep_rows *r);
