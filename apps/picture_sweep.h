/* picture_sweep.h -- a sweep as a figure. */
#pragma once

#include "figure.h"
#include "sweep.h"

/* Over one key the curves of the scene's table (sweep_show.h), with error bars
 * where they can be seen; over a grid that table's map.  Begins *f. */
void picture_sweep(const struct sweep *s, struct figure *f);
