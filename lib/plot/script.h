/* script.h -- a figure as a gnuplot script and the data it draws. */
#pragma once

#include <stdio.h>

#include "layout.h"

/* Names of the two files beside the script. */
struct script_names {
    const char *figure, *data;
};

/* How much of what gnuplot draws is the page: dots (of a PDF points), from its
 * upper left corner; and its height in mm. */
struct script_size {
    double wide, high, height;
};

/* STATUS_BAD_ARGUMENT: the page is too small for a plot.  On
 * STATUS_NO_MEMORY both files are incomplete.  Whether writing succeeded is
 * for the caller to ask the files. */
MUST_CHECK enum status script_write(const struct figure *f,
                                    const struct device *d,
                                    const struct script_names *names,
                                    FILE *script, FILE *data,
                                    struct script_size *size);
