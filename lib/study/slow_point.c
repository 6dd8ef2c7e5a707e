/* Between knots time and slip are polynomials of degree 5.  Between a steady
 * state, y = c, and the knot beside it the orbit is a line, and time and slip
 * are those of y' = lambda (y - c) plus what changes evenly. */
#include "slow_point.h"

#include <math.h>

#include "study_tolerance.h"

/* What hardly changes within an interval is its first knot's. */
static struct slow_point common(const struct slow_branch *b,
                                const struct slow_knot *k,
                                const struct slow_knot *next)
{
    return (struct slow_point){
        .fate = b->fate,
        .time_error = k->time_bar + next->time_error,
        .slip_error = k->slip_bar + next->slip_error,
        .x_slope = k->x_slope,
        .fast = k->fast,
        .gap = fmax(k->gap, next->gap),
        .fibre = k->fibre,
        .x_end = b->x_end,
        .end_slope = isfinite(b->x_end) ? b->knot[b->count - 1].time[1] : 0.0,
        .x_peak = next->x_peak,
        .mu_peak = next->mu_peak,
        .mu_near = next->mu,
    };
}

/* ---- beside a steady state ----------------------------------------------- */

/* The knot beside one; NULL: there is none. */
static const struct slow_knot *beside_state(const struct slow_branch *b)
{
    return b->grows == 0.0         ? NULL
           : b->start == SLOW_FACE ? &b->knot[b->count - 1]
                                   : &b->knot[0];
}

static bool is_between(const struct slow_branch *b, const struct slow_knot *k,
                       double y)
{
    const double part = k ? (y - b->centre) / (k->y - b->centre) : 0.0;

    return part > 0.0 && part < 1.0;
}

static void at_state(const struct slow_branch *b, const struct slow_knot *k,
                     double y, double v, struct slow_point *p)
{
    const double way = y - b->centre, whole = k->y - b->centre;
    const double fold = log(whole / way) / b->grows;
    const double time_rest = k->time[1] + 1.0 / (b->grows * whole);
    const double slip_rest = k->slip[1] + v / (b->grows * whole);

    *p = common(b, k, k == b->knot ? k + 1 : k);
    p->mu_peak = k == b->knot ? fmax(p->mu_peak, p->mu_near) : p->mu_peak;
    p->mu_near = -HUGE_VAL;
    p->x = k->x + k->x_slope * (y - k->y);
    p->time = k->time[0] + fold + time_rest * (y - k->y);
    p->slip = k->slip[0] + v * fold + slip_rest * (y - k->y);
    p->time_slope = -1.0 / (b->grows * way) + time_rest;
    p->slip_slope = -v / (b->grows * way) + slip_rest;
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
    p->time = slow_quintic(f->time, g->time, h, t, &p->time_slope);
    p->slip = slow_quintic(f->slip, g->slip, h, t, &p->slip_slope);
}

/* ---- points -------------------------------------------------------------- */

bool slow_point_at(const struct slow_branch *b, double y, double v0,
                   struct slow_point *p)
{
    const size_t i = slow_branch_interval(b, y);
    const struct slow_knot *const k = beside_state(b);

    if (i > 0)
        inside(b, i, y, p);
    else if (is_between(b, k, y))
        at_state(b, k, y, v0 * exp(k->x), p);
    else
        return false;
    return true;
}

bool slow_point_beside(const struct slow_branch *b, double y, double *x,
                       double *x_slope)
{
    const size_t i = slow_branch_interval(b, y);
    const struct slow_knot *const k = beside_state(b);

    if (i > 0 && isfinite(b->knot[i - 1].gap) && isfinite(b->knot[i].gap)) {
        *x = x_inside(&b->knot[i - 1], y, x_slope);
        return true;
    }
    if (i > 0 || !is_between(b, k, y))
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

    for (int i = 0; i < TOL_SLOW_NEWTON; i++) {
        const double off = slow_quintic(f->time, g->time, h, t, &slope) - time;
        const double next = t - off / (slope * h);
        if (fabs(off) <= TOL_SLOW_ROOT * fabs(time) ||
            fabs(next - t) < TOL_SLOW_ROOT)
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
static double solve_at_state(const struct slow_branch *b,
                             const struct slow_knot *k, double time)
{
    const double whole = k->y - b->centre;
    const double rest = k->time[1] + 1.0 / (b->grows * whole);
    double y = k->y;

    for (int i = 0; i < TOL_SLOW_NEWTON; i++) {
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
    const struct slow_knot *const k = beside_state(b);

    if (time <= first->time[0] && time >= last->time[0])
        return solve(when_inside(b, time), time);
    if ((k == first && time > first->time[0]) ||
        (k == last && time < last->time[0]))
        return solve_at_state(b, k, time);
    return NAN;
}
