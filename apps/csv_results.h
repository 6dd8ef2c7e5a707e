/* csv_results.h -- records as CSV: a line each, columns NAME [UNIT], behind a
 * number NAME_error [UNIT], and where some of a column are missing NAME_reason.
 * What is missing is empty.  Slipway's own readers take it (table.h). */
#pragma once

#include <stdio.h>

#include "record.h"

/* Of a cell: a text, in quotes where it must be; a number, nothing where it is
 * not finite; " [UNIT]" behind a name, nothing for "1". */
void csv_text(FILE *out, const char *text);
void csv_real(FILE *out, double x);
void csv_unit(FILE *out, const char *unit);

void csv_results(FILE *out, const struct record_array *a);
