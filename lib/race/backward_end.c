#include "backward_end.h"

#include <math.h>

#include "backward_tolerance.h"
#include "tolerance.h"

struct backward_way backward_way_of(const struct planar *sys,
                                    const struct carry *carry)
{
    const struct vec2 saddle = { 0.0, 0.0 };
    struct backward_way g = { .sys = sys, .carry = carry };

    for (size_t i = 0; i < carry->count; i++)
        g.converges[i] = backward_rate(&g, i, saddle, 0.0) == 0.0;
    return g;
}

double backward_rate(const struct backward_way *g, size_t i, struct vec2 z,
                     double log_scale)
{
    const int which = g->carry->which[i];
    double rate = 1.0;

    if (which != CARRY_TIME)
        g->sys->rate_gradient(g->sys->ctx, (size_t) which, z, &rate, NULL);
    return rate * exp(-log_scale);
}

struct backward_heading backward_heading_at(const struct backward_way *g,
                                            int ind, struct vec2 z)
{
    struct backward_heading c;
    struct planar_field f;

    g->sys->field(g->sys->ctx, z, &f);
    const struct vec2 d = f.direction;
    c.ind = ind >= 0 ? ind : fabs(d.y) <= fabs(d.x) ? 0 : 1;
    const double along = c.ind == 0 ? d.x : d.y;
    c.at = c.ind == 0 ? z.x : z.y;
    c.dep = c.ind == 0 ? z.y : z.x;
    c.slope = (c.ind == 0 ? d.y : d.x) / along;
    for (size_t i = 0; i < g->carry->count; i++)
        c.swift[i] = backward_rate(g, i, z, f.log_scale) / along;
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

static bool small_rest(const struct backward_way *g,
                       const struct backward_heading *earlier,
                       const struct backward_heading *now, const double total[],
                       double part, struct backward_rest *rest)
{
    const double gap = now->at - earlier->at;

    *rest = (struct backward_rest){ 0 };
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
static double room_ahead(const struct backward_way *g,
                         const struct backward_heading *c, int sign)
{
    const struct box d = g->sys->domain;
    const struct vec2 o = g->sys->origin, edge = sign > 0 ? d.hi : d.lo;

    return sign * (c->ind == 0 ? edge.x - o.x - c->at : edge.y - o.y - c->at);
}

/* Along the asymptote, what is small stays so: at strides of a unit, and of a
 * part of the way where that is long. */
static bool stays_small(const struct backward_way *g,
                        const struct backward_heading *now, int sign,
                        const double total[], double part,
                        const struct backward_rest *rest)
{
    const double room = room_ahead(g, now, sign);
    double left = 0.0, total_left[LOCAL_CARRY_MAX] = { 0.0 }, stride = 1.0;

    for (double u = 1.0; u < room; u += stride) {
        const double at = now->at + sign * u;
        const struct backward_heading c = backward_heading_at(
            g, now->ind, local_point(now->ind, at, now->dep));
        stride = fmax(1.0, TOL_BACKWARD_STRIDE * u);
        left += stride * fabs(c.slope);
        for (size_t i = 0; i < g->carry->count; i++)
            total_left[i] += stride * fabs(c.swift[i]);
    }
    bool small =
        left <= TOL_BAR_FIRST_ORDER * fabs(rest->dep) + part * fabs(now->dep);
    for (size_t i = 0; i < g->carry->count; i++)
        small &= !g->converges[i] ||
                 total_left[i] <= TOL_BAR_FIRST_ORDER * fabs(rest->total[i]) +
                                      part * fabs(total[i]);
    return small;
}

bool backward_end_near(const struct backward_way *g,
                       const struct backward_heading *earlier,
                       const struct backward_heading *now, const double total[],
                       double part, struct backward_rest *rest)
{
    const int sign = now->at > earlier->at ? 1 : -1;

    return now->ind == earlier->ind &&
           small_rest(g, earlier, now, total, part, rest) &&
           stays_small(g, now, sign, total, part, rest);
}
