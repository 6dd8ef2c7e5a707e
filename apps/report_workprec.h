/* report_workprec.h -- the head of a race as text. */
#ifndef APPS_REPORT_WORKPREC_H
#define APPS_REPORT_WORKPREC_H

#include <stdio.h>

#include "workprec.h"

/* What stands above the results of a race (run: a struct workprec): whose it
 * is, and how many runs failed. */
void report_workprec_print(FILE *out, const void *run);

#endif
