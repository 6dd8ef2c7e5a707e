#include "eigen_end.h"

#include <math.h>

#include "eigen_tolerance.h"
#include "tolerance.h"

struct eigen_heading eigen_heading_at(const struct eigen_frame *g, int ind,
                                      struct vec2 z)
{
    struct eigen_heading c;
    struct planar_field f;

    g->sys->field(g->sys->ctx, z, &f);
    const struct vec2 d = f.direction;
    c.ind = ind >= 0 ? ind : fabs(d.y) <= fabs(d.x) ? 0 : 1;
    const double along = c.ind == 0 ? d.x : d.y;
    c.at = c.ind == 0 ? z.x : z.y;
    c.dep = c.ind == 0 ? z.y : z.x;
    c.slope = (c.ind == 0 ? d.y : d.x) / along;
    for (size_t i = 0; i < g->carry->count; i++)
        c.swift[i] = eigen_rate(g, i, z, f.log_scale) / along;
    return c;
}

/* What is left of a quantity whose rate went from `earlier` to `now` over the
 * stretch `gap`, if it goes on so; infinite where it does not decay. */
static double remainder_of(double earlier, double now, double gap)
{
    const double decay = log(earlier / now) / fabs(gap);

    if (now == 0.0)
        return 0.0;
    return decay > TOL_LIMIT_DECAY ? copysign(now, now * gap) / decay
                                   : HUGE_VAL;
}

static bool small_rest(const struct eigen_frame *g,
                       const struct eigen_heading *earlier,
                       const struct eigen_heading *now, const double total[],
                       double part, struct eigen_rest *rest)
{
    const double gap = now->at - earlier->at;

    *rest = (struct eigen_rest){ 0 };
    rest->dep = remainder_of(earlier->slope, now->slope, gap);
    if (!(fabs(rest->dep) <= part * fabs(now->dep)))
        return false;
    for (size_t i = 0; i < g->carry->count; i++) {
        if (!g->converges[i])
            continue;
        rest->total[i] = remainder_of(earlier->swift[i], now->swift[i], gap);
        if (!(fabs(rest->total[i]) <= part * fabs(total[i])))
            return false;
    }
    return true;
}

/* Distance from the point to the edge of the domain along its heading. */
static double room_ahead(const struct eigen_frame *g,
                         const struct eigen_heading *c, int sign)
{
    const struct box d = g->sys->domain;
    const struct vec2 o = g->sys->origin, edge = sign > 0 ? d.hi : d.lo;

    return sign * (c->ind == 0 ? edge.x - o.x - c->at : edge.y - o.y - c->at);
}

/* Along the asymptote, what is small stays so: at strides of a unit, and of a
 * part of the way where that is long. */
static bool stays_small(const struct eigen_frame *g,
                        const struct eigen_heading *now, int sign,
                        const double total[], double part,
                        const struct eigen_rest *rest)
{
    const double room = room_ahead(g, now, sign);
    double left = 0.0, total_left[LOCAL_CARRY_MAX] = { 0.0 }, stride = 1.0;

    for (double u = 1.0; u < room; u += stride) {
        const double at = now->at + sign * u;
        const struct eigen_heading c =
            eigen_heading_at(g, now->ind, local_point(now->ind, at, now->dep));
        stride = fmax(1.0, TOL_EIGEN_STRIDE * u);
        left += stride * fabs(c.slope);
        for (size_t i = 0; i < g->carry->count; i++)
            total_left[i] += stride * fabs(c.swift[i]);
    }
    bool small =
        left <= TOL_EIGEN_RESTS * fabs(rest->dep) + part * fabs(now->dep);
    for (size_t i = 0; i < g->carry->count; i++)
        small &= !g->converges[i] ||
                 total_left[i] <= TOL_EIGEN_RESTS * fabs(rest->total[i]) +
                                      part * fabs(total[i]);
    return small;
}

bool eigen_end_near(const struct eigen_frame *g,
                    const struct eigen_heading *earlier,
                    const struct eigen_heading *now, const double total[],
                    double part, struct eigen_rest *rest)
{
    const int sign = now->at > earlier->at ? 1 : -1;

    return now->ind == earlier->ind &&
           small_rest(g, earlier, now, total, part, rest) &&
           stays_small(g, now, sign, total, part, rest);
}
