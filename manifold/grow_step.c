#include "grow_step.h"

#include <assert.h>
#include <math.h>

#include "many.h"
#include "tolerance.h"

/* What an error of the unknown is measured against: y against the distance
 * from the saddle, x - which has the limit we are after - against itself, or
 * where it passes through zero against the curve's rise.  Where a graph leans,
 * the other one is off by lean times that. */
static double scale_of_unknown(const struct grower *g)
{
    const double x = fabs(g->u.at[0][0]), y = fabs(g->u.at[1][0]);
    const double rise = fabs(g->u.slope) * y;

    return (g->ind == 0 ? x + y : fmax(x, fmin(rise, 1.0))) /
           fmax(1.0, fabs(g->lean));
}

/* Shortens the step so that the independent coordinate, which goes no further
 * than what a graph that leans is over, stays in the domain; true when the step
 * now ends on the edge. */
static bool clip_to_domain(struct grower *g)
{
    const double room = grower_room(g) / g->unit;

    if (room > g->h)
        return false;
    g->h = fmax(room, 0.0);
    return g->lean == 0.0;
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
    for (size_t k = 0; k < g[0]->carry->count; k++) {
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

/* How far the field's slope at a point is above that of the series, by s. */
static double slope_off(const struct grower *g, double by_s, struct vec2 field)
{
    return grower_slope(g, field) - by_s / g->unit;
}

/* What rounding makes of it. */
static double slope_rounding(const struct grower *g, double by_s)
{
    return TOL_ROUNDED * (fabs(by_s / g->unit) + fabs(g->u.slope));
}

static bool slope_holds(const struct grower *g, double by_s, double off)
{
    return fabs(off) <= slope_allowed(g) + slope_rounding(g, by_s);
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
        z[i] = grower_point(of, s[i], end[i].value);
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

/* The sum of (n + j) q^j, j > 0. */
static double sum_of(double n, double q)
{
    return q / (1.0 - q) * (n + 1.0 / (1.0 - q));
}

/* Of a part theta of the step, where slopes differ by `off`: at_end theta^n, n
 * the order, where terms that are left out fall as the last ones, |e_j| <= P
 * r^j, but for the sum of (n + j) P r^j theta^n (1 - theta^(j - 1)) over the
 * step, and rounding.  More is a kink's, which may show less at the end, or
 * look like a term there. */
static double kink_at(const struct grower *g, double theta, double by_s,
                      double off)
{
    const struct graph_end *end = &g->dep_end;
    const double at_end = slope_off(g, end->slope, g->end.J.field.direction);
    const double n = (double) g->order, fall = pow(theta, n);
    const double r = TOL_AS_BEFORE * sqrt(end->last / end->before);
    const double rest =
        r < 1.0
            ? fall * end->last * (sum_of(n, r) - sum_of(n, theta * r) / theta) /
                  (g->unit * g->h)
            : HUGE_VAL;
    const double unlike = fabs(off - fall * at_end);

    return unlike > rest + slope_rounding(g, by_s) ||
                   fabs(off) > TOL_CLEARLY * fabs(at_end)
               ? fmax(fabs(off), unlike)
               : 0.0;
}

/* Those whose ends say little, on the way; what is off there counts. */
static void look_on_the_way(struct grower *const g[], size_t n)
{
    const struct planar *sys[PARTS * GROWERS];
    struct planar_look seen[PARTS * GROWERS];
    struct graph_end end[PARTS * GROWERS];
    struct vec2 z[PARTS * GROWERS];

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
        const double off =
            slope_off(of, end[i].slope, seen[i].J.field.direction);
        of->holds = slope_holds(of, end[i].slope, off);
        of->kink =
            fmax(of->kink, kink_at(of, part_of[i % PARTS], end[i].slope, off));
    }
}

void grow_step_look(struct grower *const g[], size_t n)
{
    const int which = many_carried(g[0]->carry);
    const struct planar *sys[GROWERS];
    struct planar_look seen[GROWERS];
    struct graph_end end[GROWERS];
    struct vec2 z[GROWERS];

    go(g, n, 1, (const double[]){ 1.0 }, end, z);
    for (size_t k = 0; k < g[0]->carry->count; k++)
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

    grow_step_look(g, n);
    for (size_t i = 0; i < n; i++) {
        const struct vec2 field = g[i]->end.J.field.direction;
        const double by_s = g[i]->dep_end.slope;
        g[i]->kink = 0.0;
        g[i]->holds = slope_holds(g[i], by_s, slope_off(g[i], by_s, field));
        if (g[i]->holds && is_doubtful(g[i], grower_slope(g[i], field)))
            doubtful[doubts++] = g[i];
    }
    look_on_the_way(doubtful, doubts);
}
