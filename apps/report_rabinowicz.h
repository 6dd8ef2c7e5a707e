/* report_rabinowicz.h -- release distances and fits, as text. */
#ifndef APPS_REPORT_RABINOWICZ_H
#define APPS_REPORT_RABINOWICZ_H

#include <stdio.h>

#include "release.h"

void report_rabinowicz_print(FILE *out, const struct release *r);

#endif
