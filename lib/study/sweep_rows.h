/*
 * sweep_rows.h -- the points of a sweep, a row of one length each: where it is,
 * x[2]; value and error (and conditioning) of every column; a code for every
 * column.  A row is the same bytes in memory and in the side file.
 */
#ifndef STUDY_SWEEP_ROWS_H
#define STUDY_SWEEP_ROWS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "status.h"

struct sweep_rows {
    size_t columns;
    size_t reals; /* of a column: 2, with conditioning 3 */
    size_t width; /* of a row, in doubles */
    double *at;   /* owned; rows one after another */
    size_t count, room;
};

/* No rows yet. */
struct sweep_rows sweep_rows_of(size_t columns, bool conditioning);

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

/* Of a column value, error[, conditioning]. */
static inline double *sweep_rows_real(const struct sweep_rows *r, size_t i,
                                      size_t column)
{
    return sweep_rows_row(r, i) + 2 + column * r->reals;
}

static inline int8_t *sweep_rows_code(const struct sweep_rows *r, size_t i,
                                      size_t column)
{
    return (int8_t *) sweep_rows_real(r, i, r->columns) + column;
}

/* Ascending in x[0], then x[1]. */
void sweep_rows_sort(struct sweep_rows *r);

/* The row at exactly x among rows in that order; r->count if there is none. */
size_t sweep_rows_find(const struct sweep_rows *r, const double x[2]);

/* A second call is harmless. */
void sweep_rows_free(struct sweep_rows *r);

#endif
