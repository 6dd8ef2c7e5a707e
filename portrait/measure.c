#include "measure.h"

#include <math.h>

/* c itself, or e^c in units. */
static double measure_at(const struct measure *m, int axis, double c)
{
    return m->exponential[axis] ? exp(c - m->log_unit[axis]) : c;
}

double measure_between(const struct measure *m, int axis, double lo, double hi)
{
    return m->exponential[axis] ? -measure_at(m, axis, hi) * expm1(lo - hi)
                                : hi - lo;
}

double measure_weight(const struct measure *m, int axis, double c)
{
    return m->exponential[axis] ? measure_at(m, axis, c) : 1.0;
}
