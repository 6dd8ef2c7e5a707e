/* check_report.h -- regressions of tables for people, test harnesses and
 * programs. */
#pragma once

#include <stdio.h>

#include "json.h"
#include "regression.h"

/* What moved, one line a value, and one line of summary for the table. */
void check_report_print(FILE *out, const struct regression *r);

/* One test point a row, numbered from *number on, which moves behind them. */
void check_report_tap(FILE *out, const struct regression *r, size_t *number);

/* {file, rows, compared, moved[], failed[]}. */
json_t *check_report_json(const struct regression *r);
