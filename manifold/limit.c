#include "limit.h"

#include <math.h>

#include "tolerance.h"

bool limit_exists(const struct planar *sys, int ind, int toward, double dep)
{
    const struct vec2 to = toward > 0 ? sys->domain.hi : sys->domain.lo;
    const double way = ind == 0 ? to.x - sys->origin.x : to.y - sys->origin.y;
    const double middle = local_slope(sys, ind, local_point(ind, way / 2, dep));
    const double edge = local_slope(sys, ind, local_point(ind, way, dep));

    return edge == 0.0 || log(middle / edge) > TOL_LIMIT_DECAY * fabs(way / 2);
}
