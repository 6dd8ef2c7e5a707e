/* difference.h -- how a number answers to an input, by what it is where that
 * is moved. */
#pragma once

#include <stdbool.h>

#include "record.h"

/* d q/d nudge from a number, q[0], and from those where the input is larger and
 * smaller by the nudge, q[1] and q[2]; false where they do not tell it: one is
 * missing, or the two differences are unlike.  *rate stays where both are. */
bool difference_rate(const struct quantity q[3], double nudge, double *rate);
