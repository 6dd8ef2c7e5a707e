/* report_rabinowicz.h -- release distances and fits, as text and as JSON. */
#ifndef APPS_REPORT_RABINOWICZ_H
#define APPS_REPORT_RABINOWICZ_H

#include <stdio.h>

#include "json.h"
#include "release.h"

void report_rabinowicz_print(FILE *out, const struct release *r);

/* The object of `rabinowicz --json`; null where nothing was measured. */
json_t *report_rabinowicz_json(const struct release *r);

#endif
