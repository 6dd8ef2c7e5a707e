/* column.h -- inside lib/store: one data set with everything a reader needs:
 * type, units, meaning, fill value, words of its codes, scales of its axes. */
#pragma once

#include <stddef.h>

#include "axis.h"
#include "hdf.h"
#include "record.h"

/* float64, int64, int8 code, or text, by `kind`; a RECORD_QUANTITY is several
 * columns.  Text is of variable length: netCDF-C 4.9 crashes on arrays of
 * fixed-length strings. */
struct column {
    const char *name;
    const char *unit; /* not stored with text */
    const char *text;
    enum record_kind kind;
    const char *const *codes; /* RECORD_CODE */
};

/* Borrows from *f. */
struct column column_of(const struct record_field *f);

/* A new data set with `rank` (0: a scalar) axes, whose extents it takes; with
 * two or more of them and many values it is compressed in chunks, which lie
 * along the last two.  Returned open, all fill values. */
hid_t column_create(struct store *st, hid_t group, const struct column *c,
                    int rank, struct axis *const axis[]);

/* A new one-dimensional data set that is itself an axis, with its values, or
 * NULL where they are written later.  NULL (noted) on failure. */
struct axis *column_axis(struct store *st, hid_t group, const struct column *c,
                         size_t count, const void *values);

/* All values of a column, in the C type of its kind. */
void column_write(struct store *st, hid_t set, const struct column *c,
                  const void *values);

/* The type of `values` there; borrowed. */
hid_t column_type(const struct store *st, const struct column *c);
