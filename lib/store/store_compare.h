/* store_compare.h -- what differs between two files opened with store_open. */
#pragma once

#include "store.h"

/* All borrowed, valid during the call. */
struct store_difference {
    const char *path; /* of a group or data set: "/critical/v_plus" */
    const char *key;  /* of its attribute; "" for the object itself */
    const char *what; /* one line: "only in the first", "another shape",
                         "3 of 40 values differ, by up to 1e-15 of them" */
};

/* Tells of every group, data set and attribute that is in one file alone or
 * not the same in both: same type, same shape, same bytes (so a NaN equals
 * itself).  First those of a, in the order they were put, then those in b
 * alone.  Of an object in one file alone its attributes are not told.  The
 * references that tie axes to data sets are not compared.
 *
 * STATUS_OK also when much differs; STATUS_IO and *fault when a file is
 * damaged; STATUS_NO_MEMORY. */
MUST_CHECK enum status store_compare(
    struct store *a, struct store *b,
    void (*tell)(void *ctx, const struct store_difference *d), void *ctx,
    struct fault *fault);
