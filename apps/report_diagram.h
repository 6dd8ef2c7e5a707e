/* report_diagram.h -- the diagrams of steady sliding in numbers: extrema,
 * folds, the cusp, the stiffest springs that still stick and slip; where chi is
 * 1. */
#ifndef APPS_REPORT_DIAGRAM_H
#define APPS_REPORT_DIAGRAM_H

#include <stdio.h>

#include "study.h"

/* What the study's stages hold of them. */
void report_diagrams_print(FILE *out, const struct study *s);

#endif
