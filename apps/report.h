/* report.h -- a study as text for people and as JSON for programs. */
#pragma once

#include <stdio.h>

#include "ensemble.h"
#include "json.h"
#include "study.h"

/* What was asked of a study: numbers with "+-".  STATUS_NO_MEMORY, with a part
 * printed. */
MUST_CHECK enum status report_print(FILE *out, const struct study *s);

/* The object of `knees --json`, as far as the study went; with its ensemble
 * (drawn.h; NULL: none). */
json_t *report_json(const struct study *s, const struct ensemble *drawn);
