/* script.h -- a figure as a gnuplot script and the data it draws. */
#ifndef PLOT_SCRIPT_H
#define PLOT_SCRIPT_H

#include <stdio.h>

#include "layout.h"

/* Names of the two files beside the script. */
struct script_names {
    const char *figure, *data;
};

/* On STATUS_NO_MEMORY both files are incomplete.  Whether writing succeeded is
 * for the caller to ask the files. */
MUST_CHECK enum status script_write(const struct figure *f,
                                    const struct device *d,
                                    const struct script_names *names,
                                    FILE *script, FILE *data);

#endif
