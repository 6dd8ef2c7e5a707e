/* plane_table.h -- tables of results in the making, whose names are known at
 * run time only. */
#pragma once

#include "plane_study.h"
#include "result.h"

/* Sensitivities have as many as there are parameters. */
enum {
    RESULTS_MOST = 40 + 2 * SYSTEM_PARAMETERS,
    FIELDS_MOST = 64 + 6 * SYSTEM_PARAMETERS,
    TYPES_MOST = 28 + SYSTEM_PARAMETERS,
    TEXTS = 8192 + 400 * SYSTEM_PARAMETERS
};

struct plane_table {
    struct record_field field[FIELDS_MOST];
    struct record_type type[TYPES_MOST];
    struct result result[RESULTS_MOST];
    size_t fields, types, results;
    char *paths; /* owned: of manifolds */
    char text[TEXTS];
    size_t letters;
    const struct result *tables[5]; /* NULL-ended */
};

/* A text that stays with the table. */
const char *plane_table_keep(struct plane_table *t, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* A field of the type that is being made. */
struct record_field *plane_table_field(struct plane_table *t, const char *name,
                                       enum record_kind kind, size_t offset,
                                       const char *text);

/* Two fields, one a state, whose first is at offset. */
void plane_table_states(const struct plane_study *s, struct plane_table *t,
                        const char *pattern, enum record_kind kind,
                        size_t offset);

/* The type of the fields since `first`. */
const struct record_type *plane_table_type(struct plane_table *t, size_t first,
                                           const char *name, const char *text,
                                           size_t size);

/* A result of columns, to be filled in. */
struct result *plane_table_result(struct plane_table *t,
                                  const struct record_type *type,
                                  uint64_t needs);
