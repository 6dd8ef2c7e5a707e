/* report_ensemble.h -- an ensemble as text and as JSON. */
#pragma once

#include <stdio.h>

#include "ensemble.h"
#include "json.h"

void report_ensemble_print(FILE *out, const struct ensemble *e);

/* draws, method, parameters, numbers{NAME{unit quantiles mean exists reasons}},
 * pushes[{FATE arrest}], sensitivity{NAME{KEY}}; a new reference, NULL without
 * memory. */
json_t *report_ensemble_json(const struct ensemble *e);
