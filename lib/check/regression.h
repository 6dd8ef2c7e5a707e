/*
 * regression.h -- are the numbers of a table still what it says?  Every row is
 * computed again through the study facade and compared.
 *
 * A number holds when it differs from the stored one by no more than the
 * tolerance that the row states for it (expected.h); where it states none, by
 * no more than the sum of the error bar of today's number, what rounding the
 * row's decimal inputs to doubles costs (conditioning.h), half a unit of the
 * stored number's last digit, and 10^(digits_lost - 15) of it.
 */
#pragma once

#include "expected.h"

/* A stored value that no longer holds. */
struct finding {
    const struct table_cell *stored; /* borrowed from the table */
    const char *column, *law;        /* borrowed, of the table and the law */
    double now;                      /* NaN: a word, or nothing */
    const char *word;   /* borrowed: of an end or type; NULL: a number */
    const char *reason; /* borrowed: why there is no number now; NULL: there is
                           one */
    double difference, tolerance; /* NaN where one of the two is no number */
};

struct row_result {
    size_t compared;         /* values */
    struct finding *finding; /* owned; what moved */
    size_t findings;
    enum status status; /* of the computation; findings are those before */
    char *reason;       /* owned; NULL if it is STATUS_OK */
};

struct regression {
    const struct table *table;      /* borrowed */
    struct row_result *row;         /* owned; one for each of the table's */
    size_t compared, moved, failed; /* values, values, rows */
};

/* Rows are spread over the threads; the result does not depend on their
 * number.  A row that cannot be computed is data (failed).  STATUS_BAD_SCENE
 * with one line in *why for a table that makes no sense, before anything is
 * computed; STATUS_STOPPED, STATUS_NO_MEMORY.  On failure *r is empty. */
MUST_CHECK enum status regression_run(struct regression *r,
                                      const struct table *t, double rtol,
                                      const struct monitor *monitor,
                                      struct fault *why);

/* A second call is harmless. */
void regression_free(struct regression *r);
