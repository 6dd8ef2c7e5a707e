/* json.h -- records as JSON: {"value", "error"} for every computed number,
 * {"value": null, "reason"} for one that does not exist. */
#ifndef APPS_JSON_H
#define APPS_JSON_H

#include <stdbool.h>

#include <jansson.h>

#include "record.h"

/* New references, owned by the caller; NULL when out of memory. */
json_t *json_quantity(const struct quantity *q);
json_t *json_record(const struct record_type *type, const void *at);
json_t *json_records(const struct record_array *a);

/* A plain number; infinities as the strings "inf" and "-inf". */
json_t *json_number(double value);

/* Writes to stdout, 17 digits, keys in the order they were added; false if
 * stdout refuses.  Steals j. */
bool json_print(json_t *j);

#endif
