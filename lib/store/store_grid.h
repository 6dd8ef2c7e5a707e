/* store_grid.h -- data sets over up to STORE_AXES axes that they share, written
 * a slab at a time, or over two and then a block of rows at a time.
 *
 *     store_put_axis(st, "/basin", "psi", "1", "state", np, psi);
 *     store_put_axis(st, "/basin", "v", "1", "slip rate", nv, v);
 *     store_put_cube(st, "/basin", &label, 2, { "psi", "v" });
 *     store_put_rows(st, "/basin", &label, first, rows, cells);     ...
 *
 *     store_put_cube(st, "/sweep", &label, 3, { "alpha", "psi", "v" });
 *     store_put_slab(st, "/sweep", &label, 1, { i }, cells_of_alpha_i); ...
 */
#pragma once

#include "record.h"
#include "store.h"

/* A float64 coordinate of a group, which layers then name. */
MUST_CHECK enum status store_put_axis(struct store *store, const char *group,
                                      const char *name, const char *unit,
                                      const char *text, size_t count,
                                      const double *values);

/* The coordinate 0, 1, ..., count - 1, of int64, written piece by piece. */
MUST_CHECK enum status store_put_index(struct store *store, const char *group,
                                       const char *name, const char *text,
                                       size_t count);

/* How many values an axis put before has. */
MUST_CHECK enum status store_axis_length(struct store *store, const char *group,
                                         const char *name, size_t *count);

enum { STORE_AXES = 4 };

/* A new data set over `rank` <= STORE_AXES axes put before, the last of which
 * runs fastest; over two or more in compressed chunks.  Of *f name, unit, text,
 * kind (RECORD_REAL or RECORD_CODE: float64, int8) and codes count.  Values
 * never written are NaN or -1. */
MUST_CHECK enum status store_put_cube(struct store *store, const char *group,
                                      const struct record_field *f, size_t rank,
                                      const char *const axis[]);

/* Rows first .. first + count - 1 of a cube of two axes: `values` holds count *
 * (length of the second axis) doubles or int8_t, row by row; of one axis count
 * of them.  Blocks of
 * STORE_CHUNK rows from row 0 on compress each chunk once. */
MUST_CHECK enum status store_put_rows(struct store *store, const char *group,
                                      const struct record_field *f,
                                      size_t first, size_t count,
                                      const void *values);

/* All values of a cube whose first `fixed` indices are at[]; none fixed: the
 * whole. */
MUST_CHECK enum status store_put_slab(struct store *store, const char *group,
                                      const struct record_field *f,
                                      size_t fixed, const size_t at[],
                                      const void *values);
