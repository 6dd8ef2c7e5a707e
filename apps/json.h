/* json.h -- records as JSON: {"value", "error"} for every computed number,
 * {"value": null, "reason"} for one that does not exist. */
#pragma once

#include <stdbool.h>
#include <stdio.h>

#include <jansson.h>

#include "record.h"

/* New references, owned by the caller; NULL when out of memory. */
json_t *json_quantity(const struct quantity *q);
json_t *json_member(const struct record_field *f, const void *member);
json_t *json_record(const struct record_type *type, const void *at);
json_t *json_records(const struct record_array *a);

/* A plain number; null for what is no finite one, such as R of a scene. */
json_t *json_number(double value);

/* A text that may be no UTF-8, which JSON cannot hold: then its bytes are
 * written as \xNN. */
json_t *json_text(const char *text);

/* For main(), before the first of these: jansson leaves out what it finds no
 * memory for, so one failure must spoil all. */
void json_watch_memory(void);

/* Writes numbers as the shortest decimals that read back (jansson knows 17
 * digits only: 0.34000000000000002), keys in the order they were added; false
 * if `out` refuses or memory ran out on the way.  Steals j. */
bool json_write(json_t *j, FILE *out);

/* The same to stdout. */
bool json_print(json_t *j);
