/* csv_results.h -- records as CSV: a line each, columns NAME [UNIT], behind a
 * number NAME_error [UNIT], and where some of a column are missing NAME_reason.
 * What is missing is empty.  Slipway's own readers take it (table.h). */
#ifndef APPS_CSV_RESULTS_H
#define APPS_CSV_RESULTS_H

#include <stdio.h>

#include "record.h"

void csv_results(FILE *out, const struct record_array *a);

#endif
