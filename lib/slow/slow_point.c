/* Between knots time and slip are polynomials of degree 5, between the saddle
 * and the first knot its series.  Between a node, y = c, and the knot beside it
 * the orbit is a line, and time and slip are those of y' = lambda (y - c) plus
 * what changes evenly. */
#include "slow_point.h"

#include <float.h>
#include <math.h>

#include "slow_tolerance.h"

/* What hardly changes within an interval is its first knot's. */
static struct slow_point common(const struct slow_branch *b,
                                const struct slow_knot *k,
                                const struct slow_knot *next)
{
    return (struct slow_point){
        .fate = b->fate,
        .time_error = k->time_bar + slow_knot_missed(&next->time_miss, 0.5),
        .slip_error = k->slip_bar + slow_knot_missed(&next->slip_miss, 0.5),
        .x_slope = k->x_slope,
        .aside = next->aside,
        .fast = k->fast,
        .gap = fmax(k->gap, next->gap),
        .fibre = k->fibre,
        .turns = fabs(k->fibre.x * next->fibre.y - k->fibre.y * next->fibre.x),
        .swing = fmax(k->swing, next->swing),
        .x_end = b->x_end,
        .x_end_error = b->x_end_error,
        .end_slope = isfinite(b->x_end) ? b->knot[b->count - 1].time[1] : 0.0,
        .x_peak = next->x_peak,
        .mu_peak = next->mu_peak,
        .end_aside = fabs(b->end_aside.x),
        .folds = next->folds,
        .x_folds = next->x_folds,
        .mu_folds = next->mu_folds,
        .mu_near = next->mu,
        .mu_y = next->mu_y,
        .mu_error = next->mu_error,
        .mu_peak_error = next->mu_peak_error,
    };
}

/* What p forgets on its way to the next knot, at least at the rate `fast`. */
static void add_folds(double fast, const struct slow_knot *next,
                      struct slow_point *p)
{
    const double folds = fmax(p->time - next->time[0], 0.0) * fast;

    p->folds += folds;
    p->x_folds += folds;
    p->mu_folds += folds;
}

static bool is_between(double centre, double end, double y)
{
    const double part = (y - centre) / (end - centre);

    return part > 0.0 && part < 1.0;
}

/* ---- beside the saddle --------------------------------------------------- */

static bool is_near(const struct slow_branch *b, double y)
{
    return b->near && is_between(0.0, b->knot->y, y);
}

/* What changes slowly is nearly even: the rates are those of the saddle at its
 * end, of the first knot at the other. */
static void near(const struct slow_branch *b, double y, struct slow_point *p)
{
    const struct slow_knot *k = b->knot;
    const struct saddle_series *u = b->near;
    const struct saddle_point at = saddle_series_on(u, y);
    const double part = y / k->y, fold = log(b->first.p / at.p) / u->lambda;
    const double length = hypot(at.p_x, at.p_y);

    *p = common(b, k, k);
    p->x = at.x;
    p->x_slope = at.x_slope;
    p->fast = u->fast + part * (k->fast - u->fast);
    p->fibre = (struct vec2){ -at.p_y / length, at.p_x / length };
    p->time = k->time[0] + fold;
    p->slip = k->slip[0] + u->v * fold + at.q - b->first.q;
    p->time_slope = -(at.p_y + at.p_x * at.x_slope) / (at.p * u->lambda);
    p->slip_slope = u->v * p->time_slope + at.q_y + at.q_x * at.x_slope;
    add_folds(fmin(u->fast, k->fast), k, p);
    const double error = (at.p_error / fabs(at.p) + TOL_ROUNDED) / u->lambda +
                         u->lambda_error * fabs(fold);
    p->time_error += error;
    p->slip_error += u->v * error + at.q_error;
}

/* ---- beside a node ------------------------------------------------------- */

static bool is_at_node(const struct slow_branch *b, double y)
{
    return b->grows != 0.0 && is_between(b->centre, b->knot[b->count - 1].y, y);
}

static void at_node(const struct slow_branch *b, double y, struct slow_point *p)
{
    const struct slow_knot *const k = &b->knot[b->count - 1];
    const double way = y - b->centre, whole = k->y - b->centre;
    const double fold = log(whole / way) / b->grows;
    const double time_rest = k->time[1] + 1.0 / (b->grows * whole);
    const double slip_rest = k->slip[1] + b->v_node / (b->grows * whole);

    *p = common(b, k, k);
    p->mu_near = -HUGE_VAL;
    p->x = k->x + k->x_slope * (y - k->y);
    p->time = k->time[0] + fold + time_rest * (y - k->y);
    p->slip = k->slip[0] + b->v_node * fold + slip_rest * (y - k->y);
    p->time_slope = -1.0 / (b->grows * way) + time_rest;
    p->slip_slope = -b->v_node / (b->grows * way) + slip_rest;
    p->time_error += fabs(time_rest * whole * whole);
    p->slip_error += fabs(slip_rest * whole * whole);
}

/* ---- between knots ------------------------------------------------------- */

/* x between knot f and the next, near enough to land by. */
static double x_inside(const struct slow_knot *f, double y, double *slope)
{
    const struct slow_knot *g = f + 1;
    const double h = g->y - f->y, t = (y - f->y) / h;
    const double rise = g->x - f->x;
    const double f1 = h * f->x_slope - rise, g1 = h * g->x_slope - rise;

    *slope = f->x_slope + t * (g->x_slope - f->x_slope);
    return f->x + t * rise + t * (1.0 - t) * ((1.0 - t) * f1 - t * g1);
}

static void inside(const struct slow_branch *b, size_t i, double y,
                   struct slow_point *p)
{
    const struct slow_knot *f = &b->knot[i - 1], *g = &b->knot[i];
    const double h = g->y - f->y, t = (y - f->y) / h;

    *p = common(b, f, g);
    p->x = slow_knot_x(f, g, t, &p->x_slope);
    p->fast += t * (g->fast - f->fast);
    p->fibre.x += t * (g->fibre.x - f->fibre.x);
    p->fibre.y += t * (g->fibre.y - f->fibre.y);
    p->time_less = slow_knot_missed(&g->time_miss, 0.5) -
                   slow_knot_missed(&g->time_miss, t);
    p->slip_less = slow_knot_missed(&g->slip_miss, 0.5) -
                   slow_knot_missed(&g->slip_miss, t);
    p->time = slow_quintic(f->time, g->time, h, t, &p->time_slope);
    p->slip = slow_quintic(f->slip, g->slip, h, t, &p->slip_slope);
    add_folds(fmin(f->fast, g->fast), g, p);
}

/* ---- points -------------------------------------------------------------- */

bool slow_point_at(const struct slow_branch *b, double y, struct slow_point *p)
{
    const size_t i = slow_branch_interval(b, y);

    if (i > 0)
        inside(b, i, y, p);
    else if (is_near(b, y))
        near(b, y, p);
    else if (is_at_node(b, y))
        at_node(b, y, p);
    else
        return false;
    return true;
}

bool slow_point_beside(const struct slow_branch *b, double y, double *x,
                       double *x_slope)
{
    const size_t i = slow_branch_interval(b, y);
    const struct slow_knot *const k = &b->knot[b->count - 1];

    if (i > 0 && isfinite(b->knot[i - 1].gap) && isfinite(b->knot[i].gap)) {
        *x = x_inside(&b->knot[i - 1], y, x_slope);
        return true;
    }
    if (i > 0)
        return false;
    if (is_near(b, y) && isfinite(b->knot->gap)) {
        *x = saddle_series_x(b->near, y, x_slope);
        return true;
    }
    if (!is_at_node(b, y))
        return false;
    *x_slope = k->x_slope;
    *x = k->x + k->x_slope * (y - k->y);
    return true;
}

/* ---- by time ------------------------------------------------------------- */

/* The interval's first knot; time falls from knot to knot. */
static const struct slow_knot *when_inside(const struct slow_branch *b,
                                           double time)
{
    size_t lo = 0, hi = b->count - 1;

    while (hi - lo > 1) {
        const size_t mid = (lo + hi) / 2;
        if (b->knot[mid].time[0] >= time)
            lo = mid;
        else
            hi = mid;
    }
    return &b->knot[lo];
}

/* Newton's method, kept between the ends. */
static double solve(const struct slow_knot *f, double time)
{
    const struct slow_knot *g = f + 1;
    const double h = g->y - f->y;
    double lo = 0.0, hi = 1.0, t = 0.5, slope;

    for (int i = 0; i < TOL_ITERATIONS; i++) {
        const double off = slow_quintic(f->time, g->time, h, t, &slope) - time;
        const double next = t - off / (slope * h);
        if (fabs(off) <= TOL_ROUNDINGS_FEW * DBL_EPSILON * fabs(time) ||
            fabs(next - t) < TOL_ROUNDINGS_FEW * DBL_EPSILON)
            break;
        if (off > 0.0)
            lo = t;
        else
            hi = t;
        t = next > lo && next < hi ? next : 0.5 * (lo + hi);
    }
    return f->y + t * h;
}

/* By fixed-point steps: what changes evenly is small there. */
static double solve_at_node(const struct slow_branch *b, double time)
{
    const struct slow_knot *const k = &b->knot[b->count - 1];
    const double whole = k->y - b->centre;
    const double rest = k->time[1] + 1.0 / (b->grows * whole);
    double y = k->y;

    for (int i = 0; i < TOL_ITERATIONS; i++) {
        const double before = y;
        const double left = time - k->time[0] - rest * (y - k->y);
        y = b->centre + whole * exp(-b->grows * left);
        if (y == before)
            break;
    }
    return y;
}

double slow_point_when(const struct slow_branch *b, double time)
{
    const struct slow_knot *first = &b->knot[0], *last = first + b->count - 1;

    if (time <= first->time[0] && time >= last->time[0])
        return solve(when_inside(b, time), time);
    if (b->near && time > first->time[0])
        return saddle_series_y(
            b->near,
            b->first.p * exp(-b->near->lambda * (time - first->time[0])));
    if (b->grows != 0.0 && time < last->time[0])
        return solve_at_node(b, time);
    return NAN;
}
