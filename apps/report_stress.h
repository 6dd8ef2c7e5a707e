/* report_stress.h -- the catalogue's results as a table, as JSON and as TAP. */
#pragma once

#include <stdio.h>

#include "json.h"
#include "stress_run.h"

/* One line a case, how many came to what, and those that are not exact once
 * more with their causes and the options that repeat them. */
void report_stress_print(FILE *out, const struct stress *s);

/* The object of `stress --json`; `list` as it was run. */
json_t *report_stress_json(const struct stress *s,
                           const struct stress_list *list);

/* One test a case: only a lie is not ok. */
void report_stress_tap(FILE *out, const struct stress *s);
