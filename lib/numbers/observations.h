/*
 * observations.h -- Rabinowicz's measurements from a CSV table (table.h).
 *
 * Columns: tan_alpha; l_k, the critical release distance, and x_k, the
 * persistence length, one of the two at least, in m; l_k_error and x_k_error,
 * one standard deviation in m, where they are known.  Other columns are
 * refused, for one that is misspelt would else be missed; an empty cell is a
 * measurement that was not made.
 */
#pragma once

#include "least.h"
#include "table.h"

/* One quantity over the slopes where it was measured; all owned. */
struct series {
    double *tan_alpha, *value;
    double *error; /* NULL: none known */
    size_t count;
};

struct observations {
    struct series l_k, x_k; /* empty where there is no such column */
};

/* STATUS_BAD_SCENE with one line FILE:LINE:COL: in *why for a column that is
 * not known or missing, and for a cell that holds no number > 0;
 * STATUS_NO_MEMORY.  On failure *o is empty. */
MUST_CHECK enum status observations_read(struct observations *o,
                                         const struct table *t,
                                         struct fault *why);

/* A second call is harmless. */
void observations_free(struct observations *o);

static inline struct measured series_measured(const struct series *s)
{
    return (struct measured){ s->tan_alpha, s->value, s->error, s->count };
}
