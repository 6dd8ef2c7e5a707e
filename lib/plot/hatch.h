/* hatch.h -- what has no value, told from every tint also in grey. */
#pragma once

#include <stdio.h>

#include "layout.h"

/* Lines at 45 degrees through a box of the page, in gnuplot's words; `layer` is
 * that of its `set arrow`: "back", "front". */
void hatch_write(FILE *out, const struct layout *p, struct box b,
                 const char *layer);
