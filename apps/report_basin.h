/* report_basin.h -- the shares and the audit of a basin map. */
#ifndef APPS_REPORT_BASIN_H
#define APPS_REPORT_BASIN_H

#include <stdio.h>

#include "study.h"

void report_basin_print(FILE *out, const struct basin_map *m,
                        const struct fields *f);

#endif
