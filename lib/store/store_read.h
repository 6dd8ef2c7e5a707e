/* store_read.h -- what is in a file opened with store_open. */
#pragma once

#include <stdint.h>

#include "store.h"

enum store_kind { STORE_GROUP, STORE_DATASET, STORE_TEXT };

enum { STORE_RANK_MAX = 32 };

/* A group, a data set, or a text attribute of either.  All borrowed, valid
 * during the call; texts are never NULL. */
struct store_item {
    enum store_kind kind;
    const char *path;                /* of the group or data set: "/basin" */
    int rank;                        /* data set: number of axes, */
    uint64_t extent[STORE_RANK_MAX]; /* and their lengths */
    const char *units;               /* data set; "" if none */
    const char *long_name;           /* data set; "" if none */
    const char *key;                 /* text attribute: name */
    const char *text;                /* text attribute: value */
};

/* Tells `visit` of everything in the file, in the order it was put, each
 * object followed by its text attributes (units, long_name and what marks an
 * axis in HDF5 are not among them; nor are texts of variable length, which
 * store.h never writes).  A non-zero answer ends the visit: STATUS_STOPPED.
 * STATUS_IO and *fault when the file is damaged; STATUS_NO_MEMORY. */
MUST_CHECK enum status store_visit(struct store *store,
                                   int (*visit)(void *ctx,
                                                const struct store_item *item),
                                   void *ctx, struct fault *fault);

/* A text attribute of a group, such as the scene: *text is owned by the caller
 * (free).  STATUS_IO and *fault when there is none; *text is then NULL. */
MUST_CHECK enum status store_read_text(struct store *store, const char *group,
                                       const char *key, char **text,
                                       struct fault *fault);
