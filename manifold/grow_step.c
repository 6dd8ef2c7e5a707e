#include "grow_step.h"

#include <assert.h>
#include <math.h>

#include "many.h"
#include "tolerance.h"

/* What an error of the unknown is measured against: y against the distance
 * from the saddle, x - which has the limit we are after - against itself, or
 * where it passes through zero against the curve's rise. */
static double scale_of_unknown(const struct grower *g)
{
    const double x = fabs(g->u.at[0][0]), y = fabs(g->u.at[1][0]);
    const double rise = fabs(g->u.slope) * y;

    return g->ind == 0 ? x + y : fmax(x, fmin(rise, 1.0));
}

/* Shortens the step so that the independent coordinate stays in the domain;
 * true when the step now ends on the edge. */
static bool clip_to_domain(struct grower *g)
{
    const struct planar *sys = g->sys;
    const double here =
        g->u.at[g->ind][0] + grower_coordinate(sys->origin, g->ind);
    const double edge = grower_coordinate(
        g->toward > 0 ? sys->domain.hi : sys->domain.lo, g->ind);
    const double room = (edge - here) * g->toward / g->unit;

    if (room > g->h)
        return false;
    g->h = fmax(room, 0.0);
    return true;
}

void grow_step_choose(struct grower *const g[], size_t n)
{
    const size_t order = g[0]->o->order;
    const double *u[GROWERS];
    double to[GROWERS], reach[GROWERS];

    assert(n > 0);
    for (size_t i = 0; i < n; i++) {
        u[i] = g[i]->u.at[1 - g[i]->ind];
        to[i] = g[i]->tol * scale_of_unknown(g[i]);
    }
    graph_reach(order, n, u, to, reach);
    for (size_t i = 0; i < n; i++) {
        const double far = fabs(g[i]->u.at[g[i]->ind][0]) / g[i]->unit;
        g[i]->h = fmin(reach[i], fmax(TOL_STEP_MOST, far)); /* where flat */
        if (g[i]->o->longest > 0.0)
            g[i]->h = fmin(g[i]->h, g[i]->o->longest / g[i]->unit);
    }
    for (size_t k = 0; k < g[0]->o->carry.count; k++) {
        for (size_t i = 0; i < n; i++) {
            u[i] = g[i]->u.integral[k];
            to[i] = fabs(g[i]->total[k]) + fabs(u[i][1]) * g[i]->h;
            to[i] = to[i] > INTEGRAL_NIL ? g[i]->tol * to[i] : HUGE_VAL;
        }
        graph_reach(order, n, u, to, reach);
        for (size_t i = 0; i < n; i++)
            g[i]->h = to[i] < HUGE_VAL ? fmin(g[i]->h, reach[i]) : g[i]->h;
    }
    for (size_t i = 0; i < n; i++)
        g[i]->edge = clip_to_domain(g[i]);
}

/* How far the series' slope may be from the field's. */
static double slope_allowed(const struct grower *g)
{
    return TOL_SLOPE_CHECK * g->tol * scale_of_unknown(g) / (g->unit * g->h);
}

/* The series' slope by s at a point against the field's there; *off: their
 * difference. */
static bool slope_holds(const struct grower *g, double by_s, double field,
                        double *off)
{
    const double slope = by_s / g->unit;
    const double rounding = TOL_ROUNDED * (fabs(slope) + fabs(g->u.slope));

    *off = fabs(slope - field);
    return *off <= slope_allowed(g) + rounding;
}

/* Whether the step's end alone says little: the slope has faded to nothing
 * there, past a kink or not, or is little anyway, or the step leaps. */
static bool is_doubtful(const struct grower *g, double field)
{
    const double slope = fabs(g->u.slope);

    return fabs(field) < TOL_FAR_BELOW * slope ||
           slope < TOL_SLOPE_LITTLE * slope_allowed(g) ||
           g->unit * g->h > TOL_STEP_LEAP * g->last;
}

/* The parts of a step where it is looked at on the way. */
enum { PARTS = 3 };
static const double part_of[PARTS] = { 0.5, 0.75, 0.9 };

/* What dep's series are at part[k] of the steps, n of each; and where. */
static void go(struct grower *const g[], size_t count, size_t n,
               const double part[], struct graph_end end[], struct vec2 z[])
{
    const double *u[PARTS * GROWERS];
    double s[PARTS * GROWERS];

    assert(count * n > 0);
    for (size_t i = 0; i < count * n; i++) {
        const struct grower *of = g[i / n];
        u[i] = of->u.at[1 - of->ind];
        s[i] = part[i % n] * of->toward * of->h;
    }
    graph_ends(g[0]->order, count * n, u, s, end);
    for (size_t i = 0; i < count * n; i++) {
        const struct grower *of = g[i / n];
        z[i] = local_point(of->ind, of->u.at[of->ind][0] + s[i] * of->unit,
                           end[i].value);
    }
}

static void integrals_at_ends(struct grower *const g[], size_t n, size_t k)
{
    const double *u[GROWERS];
    double s[GROWERS];
    struct graph_end end[GROWERS];

    assert(n > 0);
    for (size_t i = 0; i < n; i++) {
        u[i] = g[i]->u.integral[k];
        s[i] = g[i]->toward * g[i]->h;
    }
    graph_ends(g[0]->order, n, u, s, end);
    for (size_t i = 0; i < n; i++)
        g[i]->integral_end[k] = end[i];
}

/* Those whose ends say little, on the way; what is off there counts. */
static void look_on_the_way(struct grower *const g[], size_t n)
{
    const struct planar *sys[PARTS * GROWERS];
    struct planar_look seen[PARTS * GROWERS];
    struct graph_end end[PARTS * GROWERS];
    struct vec2 z[PARTS * GROWERS];
    double at_end, off;

    if (n == 0)
        return;
    go(g, n, PARTS, part_of, end, z);
    for (size_t i = 0; i < n * PARTS; i++)
        sys[i] = g[i / PARTS]->sys;
    many_at(sys, n * PARTS, z, -1, false, seen);
    for (size_t i = 0; i < n * PARTS; i++) {
        struct grower *of = g[i / PARTS];
        if (!of->holds)
            continue;
        slope_holds(of, of->dep_end.slope,
                    local_quotient(of->ind, of->end.J.field.direction),
                    &at_end);
        of->holds = slope_holds(
            of, end[i].slope,
            local_quotient(of->ind, seen[i].J.field.direction), &off);
        if (off > TOL_CLEARLY * at_end)
            of->kink = fmax(of->kink, off);
    }
}

void grow_step_look(struct grower *const g[], size_t n)
{
    const int which = many_carried(&g[0]->o->carry);
    const struct planar *sys[GROWERS];
    struct planar_look seen[GROWERS];
    struct graph_end end[GROWERS];
    struct vec2 z[GROWERS];

    go(g, n, 1, (const double[]){ 1.0 }, end, z);
    for (size_t k = 0; k < g[0]->o->carry.count; k++)
        integrals_at_ends(g, n, k);
    for (size_t i = 0; i < n; i++)
        sys[i] = g[i]->sys;
    many_at(sys, n, z, which, true, seen);
    for (size_t i = 0; i < n; i++) {
        g[i]->end = seen[i];
        g[i]->at_end = z[i];
        g[i]->dep_end = end[i];
    }
}

void grow_step_try(struct grower *const g[], size_t n)
{
    struct grower *doubtful[GROWERS];
    size_t doubts = 0;
    double off;

    grow_step_look(g, n);
    for (size_t i = 0; i < n; i++) {
        const double field =
            local_quotient(g[i]->ind, g[i]->end.J.field.direction);
        g[i]->kink = 0.0;
        g[i]->holds = slope_holds(g[i], g[i]->dep_end.slope, field, &off);
        if (g[i]->holds && is_doubtful(g[i], field))
            doubtful[doubts++] = g[i];
    }
    look_on_the_way(doubtful, doubts);
}
