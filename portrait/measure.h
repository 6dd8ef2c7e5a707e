/* measure.h -- a measure of the plane: each coordinate, or exp of it, counts
 * evenly. */
#pragma once

#include <stdbool.h>

struct measure {
    bool exponential[2];
    double log_unit[2]; /* exp is counted in units of e^log_unit, lest it
                           overflow: the top of what is measured */
};

/* From lo to hi, to rounding of the result. */
double measure_between(const struct measure *m, int axis, double lo, double hi);

/* What a coordinate's change counts at c: 1, or e^c in units. */
double measure_weight(const struct measure *m, int axis, double c);
