/* sweep_finish.h -- inside sweep.c: what is done when all rows are there. */
#pragma once

#include "sweep.h"

/* Sets the axes and the number of points; numbers the reasons as they come from
 * the first point to the last, which is not how they arrived; leaves off the
 * columns of steady states that no point has; counts failures.
 * STATUS_NO_MEMORY. */
MUST_CHECK enum status sweep_finish(struct sweep *s);
