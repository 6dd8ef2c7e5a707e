/* report_sweep.h -- a sweep as text for people and as JSON for programs. */
#ifndef APPS_REPORT_SWEEP_H
#define APPS_REPORT_SWEEP_H

#include <stdio.h>

#include "json.h"
#include "sweep.h"

/* v_sp, v_minus, v_plus and mu_s at some of the points, and how many of them
 * lack v_plus or v_minus, and why. */
void report_sweep_print(FILE *out, const struct sweep *s);

/* {"law", "form", "keys": [{"key", "name", "unit", "values"}], "points",
 * "failed", "reasons", "numbers": {NAME: {"value": [...], "error": [...],
 * "reason": [...]}}}: one value a point, null where there is none and "reason"
 * then an index into "reasons", else null; of a code its word.  A new
 * reference, NULL without memory. */
json_t *report_sweep_json(const struct sweep *s);

/* The points that a scene asks for, in one phrase, and how many. */
size_t report_sweep_plan(const struct scene *s, char *text, size_t size);

#endif
