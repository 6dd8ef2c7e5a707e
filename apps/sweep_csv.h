/* sweep_csv.h -- the numbers of a sweep as CSV, a line for each point: the
 * keys, then each entry of each column, NAME [UNIT] with its number behind the
 * name where there are more, NAME_error [UNIT], and where some are missing
 * NAME_reason; in the scene's units (sweep_told.h). */
#pragma once

#include <stdio.h>

#include "sweep.h"

/* STATUS_NO_MEMORY: nothing is written. */
MUST_CHECK enum status sweep_csv(FILE *out, const struct sweep *s);
