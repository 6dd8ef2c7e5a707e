/* report_workprec.h -- work-precision diagrams as text. */
#ifndef APPS_REPORT_WORKPREC_H
#define APPS_REPORT_WORKPREC_H

#include <stdio.h>

#include "workprec.h"

/* Who is fastest at which accuracy, what failed, and where it was measured. */
void report_workprec_print(FILE *out, const struct workprec *w);

#endif
