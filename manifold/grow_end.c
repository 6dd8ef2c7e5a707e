#include "grow_end.h"

#include <math.h>

#include "close.h"
#include "grow_error.h"
#include "limit.h"
#include "tolerance.h"

/* Whether everything still unknown changes by less than `part` of itself per
 * unit of the independent coordinate. */
static bool hardly_changes(const struct grower *g, double part)
{
    const double unknown = fabs(vec2_part(g->z, 1 - g->ind));

    if (!(fabs(g->out.slope) <= part * fmin(1.0, unknown)))
        return false;
    for (size_t i = 0; i < g->carry->count; i++)
        if (g->b->from_saddle[i] &&
            !(fabs(g->out.swift[i]) <= part * fabs(g->total[i])))
            return false;
    return true;
}

static bool is_inside_reach(const struct grower *g)
{
    return g->o->reach &&
           box_holds(*g->o->reach, vec2_add(g->sys->origin, g->z));
}

/* Inside the reach a branch is followed until nothing at all changes. */
static bool may_close(const struct grower *g)
{
    if (is_inside_reach(g))
        return hardly_changes(g, TOL_NOTHING);
    return hardly_changes(g, fmin(TOL_TAIL_PART * sqrt(g->o->rtol), TOL_SEEN));
}

/* A limit that was seen to exist does so while the same coordinate goes on: dep
 * hardly changes from then on. */
static bool has_limit(struct grower *g)
{
    if (g->limited != 1 + g->ind &&
        limit_exists(g->sys, g->ind, g->toward, vec2_part(g->z, 1 - g->ind)))
        g->limited = 1 + g->ind;
    return g->limited == 1 + g->ind;
}

bool grow_end_is_open(struct grower *g)
{
    return !is_inside_reach(g) && hardly_changes(g, TOL_SEEN) &&
           g->toward * g->out.slope_d <= 0.0 && !has_limit(g);
}

/* The tail adds little to the bars; at the latest where it adds little to the
 * numbers. */
static struct tail_most most_of(const struct grower *g)
{
    const bool late = hardly_changes(g, TOL_ROOT);
    const double part = TOL_TAYLOR_STEP * g->o->rtol;
    const double unknown = fabs(vec2_part(g->z, 1 - g->ind));
    struct tail_most most = { .unknown =
                                  late ? HUGE_VAL : part * fmin(1.0, unknown) };

    for (size_t i = 0; i < g->carry->count; i++)
        most.integral[i] =
            late || !g->b->from_saddle[i] ? HUGE_VAL : part * fabs(g->total[i]);
    return most;
}

bool grow_end_close(struct grower *g)
{
    struct tail t;

    if (!may_close(g))
        return false;
    const struct tail_most most = most_of(g);
    if (!close_tail(g->sys, g->ind, g->toward, g->z, &g->end, g->carry, &most,
                    &t) ||
        !has_limit(g))
        return false;
    grow_error_tail(g, 1.0 + t.unknown_by_dep, t.integral_by_dep);
    g->b->end = g->ind == 1 ? BRANCH_LIMIT_X : BRANCH_LIMIT_Y;
    g->b->sign = g->toward;
    *(g->ind == 1 ? &g->z.x : &g->z.y) += t.unknown;
    g->miss.bar += TOL_BAR_FIRST_ORDER * t.unknown_error;
    for (size_t i = 0; i < g->carry->count; i++) {
        g->total[i] += t.integral[i];
        g->total_miss[i].bar += TOL_BAR_FIRST_ORDER * t.integral_error[i];
    }
    return true;
}
