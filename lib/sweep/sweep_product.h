/*
 * sweep_product.h -- inside sweep_column.c: which columns each product gives.
 */
#ifndef SWEEP_SWEEP_PRODUCT_H
#define SWEEP_SWEEP_PRODUCT_H

#include "sweep_column.h"

/* Columns on their way into *to. */
struct column_adder {
    struct sweep_columns *to;
    const struct scene *scene;
    const struct sweep_dims *dims;
    unsigned stages; /* of the products */
};

/* Members of one record: where it is, along what, and what precedes its names.
 */
struct column_part {
    const char *prefix;
    enum sweep_source source;
    size_t base;   /* of the record there */
    size_t stride; /* to the next of them */
    enum sweep_dim dim[COLUMN_DIMS];
    size_t dims;
};

/* Adds a column for a member of such a record, or one for each of its
 * quantities and codes.  STATUS_NO_MEMORY. */
MUST_CHECK enum status column_add(const struct column_adder *a,
                                  const struct column_part *part,
                                  const struct record_field *f);
MUST_CHECK enum status column_add_record(const struct column_adder *a,
                                         const struct column_part *part,
                                         const struct record_type *type);

/* Adds a column for a number of the study.  STATUS_NO_MEMORY. */
MUST_CHECK enum status column_add_number(const struct column_adder *a,
                                         const struct result_number *n);

/* Adds all columns of a->scene's products.  STATUS_NO_MEMORY. */
MUST_CHECK enum status sweep_product_add(const struct column_adder *a);

#endif
