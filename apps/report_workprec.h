/* report_workprec.h -- work-precision diagrams as text for people and as JSON
 * for programs. */
#ifndef APPS_REPORT_WORKPREC_H
#define APPS_REPORT_WORKPREC_H

#include <stdio.h>

#include "json.h"
#include "workprec.h"

/* Who is fastest at which accuracy, what failed, and where it was measured. */
void report_workprec_print(FILE *out, const struct workprec *w);

/* {"runs": [...], "fastest": [...], "missing": {quantity: reason},
 * "environment": {...}}; owned by the caller. */
json_t *report_workprec_json(const struct workprec *w);

#endif
