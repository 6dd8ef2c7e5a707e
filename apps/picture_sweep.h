/* picture_sweep.h -- a sweep as a figure. */
#ifndef APPS_PICTURE_SWEEP_H
#define APPS_PICTURE_SWEEP_H

#include "figure.h"
#include "sweep.h"

/* Over one key the curves of the scene's table (sweep_show.h), with error bars
 * where they can be seen; over a grid that table's map.  Freed by
 * figure_free.  STATUS_NO_MEMORY leaves *f FIGURE_EMPTY. */
MUST_CHECK enum status picture_sweep(const struct sweep *s, struct figure *f);

#endif
