/* ticks.h -- where an axis has ticks and what they say. */
#pragma once

#include <stdio.h>

#include "scale.h"

/* Writes "('label' position level, ...)", level 0 with a label, 1 without, at
 * least 3 labels; at most 8, about `spacing` pixels or more apart, where these
 * are 3, and evenly on linear axes.  Log axes: decades, every 1, 2, 3, 5, 10,
 * ...; below two decades also 2 and 5; well below one, and on linear axes,
 * multiples of 1, 2 or 5 times a power of ten.  script: of label.h; place: what
 * gnuplot's axis has at a value, NULL: the value. */
void ticks_write(FILE *out, const struct scale *s, double spacing,
                 double script, double place(double));

/* The values that ticks_write labels between the ends, and what they say there;
 * returns how many, TICKS_LABELS at most. */
enum { TICKS_LABELS = 12 };
struct tick_label {
    double at;
    char text[64]; /* with marks */
};
size_t ticks_labels(const struct scale *s, double spacing,
                    struct tick_label label[TICKS_LABELS]);

/* Such a text as gnuplot has it, enhanced. */
void ticks_put(FILE *out, const char *text, double script);

/* Upper estimate of the widest label in units of the font size. */
double ticks_width(const struct scale *s, double spacing);
