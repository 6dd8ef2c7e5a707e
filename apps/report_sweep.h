/* report_sweep.h -- a sweep as text for people. */
#pragma once

#include <stdio.h>

#include "sweep.h"

/* At some of the points v_sp, v_minus, v_plus and mu_s, shares of the basins,
 * release distances and how each run ends, as far as they were asked for; how
 * many points lack v_plus or v_minus, and why; the ranges of maps. */
void report_sweep_print(FILE *out, const struct sweep *s);

/* The points that a scene asks for, in one phrase, and how many. */
size_t report_sweep_plan(const struct scene *s, char *text, size_t size);
