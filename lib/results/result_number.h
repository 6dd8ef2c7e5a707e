/*
 * result_number.h -- the numbers of a run one by one, each by the name that it
 * has where it stands alone, in sweeps and tables: its place in JSON with
 * underscores for dots and brackets.
 */
#pragma once

#include "result.h"

/* What of it: its value and bar, or what is proved to be at most and at least
 * it. */
enum result_part { RESULT_VALUE, RESULT_LO, RESULT_HI };

struct result_number {
    const struct result *of;
    size_t instance, row;             /* row: of columns; else 0 */
    const struct record_field *field; /* a quantity, a code or a count */
    enum result_part part;            /* of a quantity */
    char name[RESULT_NAME];
};

struct result_numbers {
    struct result_number *at; /* owned */
    size_t count, room;
};

/* Those asked for; rows of columns (result.h: alone) come last.  all->run may
 * be NULL, or a run that only counts.  STATUS_NO_MEMORY leaves *n empty. */
MUST_CHECK enum status result_numbers_init(struct result_numbers *n,
                                           const struct results *all);

/* A second call is harmless. */
void result_numbers_free(struct result_numbers *n);

/* NULL if there is none of that name. */
const struct result_number *result_numbers_find(const struct result_numbers *n,
                                                const char *name);

/* What a run has there: reals and counts are exact; of a code -1: none. */
struct quantity result_quantity(const struct results *all,
                                const struct result_number *n);
int8_t result_code(const struct results *all, const struct result_number *n);
