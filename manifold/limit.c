#include "limit.h"

#include <math.h>

#include "tolerance.h"

static double way_to_edge(const struct planar *sys, int ind, int toward)
{
    const struct vec2 to = toward > 0 ? sys->domain.hi : sys->domain.lo;

    return ind == 0 ? to.x - sys->origin.x : to.y - sys->origin.y;
}

bool limit_exists(const struct planar *sys, int ind, int toward, double dep)
{
    const double way = way_to_edge(sys, ind, toward);
    const double edge = local_slope(sys, ind, local_point(ind, way, dep));

    if (edge == 0.0)
        return true;
    const double middle = local_slope(sys, ind, local_point(ind, way / 2, dep));
    return log(middle / edge) > TOL_LIMIT_DECAY * fabs(way / 2);
}

bool limit_is_none(const struct planar *sys, int ind, int toward, double dep)
{
    const double way = way_to_edge(sys, ind, toward);
    const double far = sys->axis[ind].is_log ? 1.0 : sqrt(TOL_RANGE);
    const double middle = local_slope(sys, ind, local_point(ind, way / 2, dep));
    const double edge = local_slope(sys, ind, local_point(ind, way * far, dep));

    return 2.0 * far * edge / middle >= TOL_LIMIT_KEPT;
}
