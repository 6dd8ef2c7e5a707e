#include "difference.h"

#include <math.h>

#include "tolerance.h"

enum { HERE, UP, DOWN };

bool difference_rate(const struct quantity q[3], double nudge, double *rate)
{
    const struct quantity *up = &q[UP], *down = &q[DOWN];
    const bool above = quantity_exists(up), below = quantity_exists(down);

    if (!quantity_exists(q) || (!above && !below))
        return !quantity_exists(q);
    if (!above || !below) {
        *rate = ((above ? up : down)->value - q->value) / nudge;
        return false;
    }
    const double first = up->value - down->value;
    const double second = up->value - 2.0 * q->value + down->value;
    const double noise = 10.0 * TOL_RTOL_DEFAULT * fabs(q->value);
    *rate = first / (2.0 * nudge);
    return fabs(second) <= TOL_FAR_BELOW * fabs(first) + noise;
}
