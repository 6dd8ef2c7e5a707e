/* look.h -- a line's and a mark's look in gnuplot's words. */
#pragma once

#include <stdio.h>

#include "layout.h"
#include "palette.h"

/* "lw ... lc ... dt ..." */
void look_line(FILE *out, const struct device *d, const struct paint *p);

/* gnuplot's point type. */
int look_type(enum figure_mark mark);

/* "pt ... ps ... lw ... lc ..." */
void look_mark(FILE *out, const struct device *d,
               const struct figure_layer *layer);
