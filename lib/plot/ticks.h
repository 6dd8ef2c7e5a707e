/* ticks.h -- where an axis has ticks and what they say. */
#ifndef PLOT_TICKS_H
#define PLOT_TICKS_H

#include <stdio.h>

#include "scale.h"

/* Writes "('label' position level, ...)", level 0 with a label, 1 without, at
 * least 3 labels; at most 8, about `spacing` pixels or more apart, where these
 * are 3.  Log axes: decades,
 * every 1, 2, 3, 5, 10, ...; below two decades also 2 and 5; well below one,
 * and on linear axes, multiples of 1, 2 or 5 times a power of ten.  script: of
 * label.h. */
void ticks_write(FILE *out, const struct scale *s, double spacing,
                 double script);

/* Upper estimate of the widest label in units of the font size. */
double ticks_width(const struct scale *s, double spacing);

#endif
