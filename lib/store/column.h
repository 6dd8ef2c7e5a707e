/* column.h -- inside lib/store: one data set with everything a reader needs:
 * type, units, meaning, fill value, words of its codes, scales of its axes. */
#ifndef STORE_COLUMN_H
#define STORE_COLUMN_H

#include <stddef.h>

#include <hdf5.h>

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

/* A new data set with one axis for each of `rank` (0: a scalar) open scales,
 * whose extents it takes; two-dimensional ones are chunked and compressed.
 * Returned open, all fill values. */
hid_t column_create(struct store *st, hid_t group, const struct column *c,
                    int rank, const hid_t axis[]);

/* A new one-dimensional data set that is itself an axis, with its values.
 * Returned open, to be given to column_create. */
hid_t column_axis(struct store *st, hid_t group, const struct column *c,
                  size_t count, const void *values);

/* All values of a column, in the C type of its kind. */
void column_write(struct store *st, hid_t set, const struct column *c,
                  const void *values);

/* What column_write hands to HDF5: borrowed, but for text, which the caller
 * closes with column_type_close. */
hid_t column_type(struct store *st, const struct column *c);
void column_type_close(const struct column *c, hid_t type);

#endif
