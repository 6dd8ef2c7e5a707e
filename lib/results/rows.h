/* rows.h -- a table of records while it is filled: what a curve is written
 * as. */
#pragma once

#include "result.h"

/* A growable table of one record type; at is owned. */
struct rows {
    const struct record_type *type;
    void *at; /* owned */
    size_t count, room;
};

struct rows rows_of(const struct record_type *type);
void rows_free(struct rows *r);

/* Adds a copy of one record.  STATUS_NO_MEMORY: *r is as it was. */
MUST_CHECK enum status rows_push(struct rows *r, const void *row);

/* Lends rows, which the view then owns, if they could be sampled. */
MUST_CHECK enum status rows_lend(struct result_view *out, struct rows *r,
                                 enum status sampled);

/* A view of a struct *s, the run, that fills rows r of its type. */
#define ROWS_VIEW(function, struct_, sampled)                                  \
    static enum status function(const void *run, size_t k,                     \
                                struct result_view *out)                       \
    {                                                                          \
        const struct struct_ *s = run;                                         \
        struct rows r = rows_of(out->records.type);                            \
        (void) k;                                                              \
        return rows_lend(out, &r, sampled);                                    \
    }
