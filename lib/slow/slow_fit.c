/* The field's second derivatives along the curve are what is left of two terms
 * 1/gap times larger: where the rates are far apart values and slopes of three
 * knots are better. */
#include "slow_fit.h"

#include <math.h>

#include "slow_tolerance.h"

/* Whether rates come from a slope that is mostly noise: y' is what is left of
 * two large terms. */
static bool is_blurred(const struct slow_knot *k)
{
    return slow_knot_is_fast_y(k) && k->gap < TOL_SLOW_NOISY;
}

/* The second derivative of time or slip, whose values are still the steps'. */
static double bend_of(const double f[3], const double k[3], const double g[3],
                      double before, double after)
{
    const double from[3] = { -k[0], f[1] }, at[3] = { 0.0, k[1] };

    return slow_knot_bend(from, at, g, before, after);
}

/* The second derivatives at k from what lies around it. */
static void smooth_one(const struct slow_knot *f, struct slow_knot *k,
                       const struct slow_knot *g)
{
    const double x[3][3] = { { f->x, f->x_slope },
                             { k->x, k->x_slope },
                             { g->x, g->x_slope } };
    const double before = f->y - k->y, after = g->y - k->y;

    k->x_bend = slow_knot_bend(x[0], x[1], x[2], before, after);
    if (!is_blurred(k))
        return;
    k->time[2] = bend_of(f->time, k->time, g->time, before, after);
    k->slip[2] = bend_of(f->slip, k->slip, g->slip, before, after);
}

/* Second derivatives of the field's slopes are mostly noise where the rates are
 * far apart. */
void slow_fit_smooth(struct slow_branch *b)
{
    struct slow_knot *const k = b->knot;
    const size_t last = b->count - 1;

    for (size_t i = 1; i < last; i++)
        if (k[i].gap < TOL_SLOW_NOISY)
            smooth_one(&k[i - 1], &k[i], &k[i + 1]);
    if (k[0].gap < TOL_SLOW_NOISY)
        k[0].x_bend = k[1].x_bend;
    if (k[last].gap < TOL_SLOW_NOISY)
        k[last].x_bend = k[last - 1].x_bend;
}

/* How far off in y a state lands that is right in its slow coordinate, beside a
 * curve that is off by dx. */
static double shift_of(const struct slow_knot *k, double dx)
{
    return fabs(k->fibre.y * dx / (k->fibre.x - k->fibre.y * k->x_slope));
}

/* What a polynomial over two steps misses at the knot between is 64 times what
 * one over one step misses; twice, if it is noise in the slopes. */
void slow_fit_judge(struct slow_branch *b)
{
    struct slow_knot *const k = b->knot;
    double ignored;

    for (size_t i = 1; i + 1 < b->count; i++) {
        const struct slow_knot *f = &k[i - 1], *g = &k[i + 1];
        const double h = g->y - f->y, theta = (k[i].y - f->y) / h;
        const double x = slow_knot_x(f, g, theta, &ignored);
        const double t = slow_quintic(f->time, g->time, h, theta, &ignored);
        const double l = slow_quintic(f->slip, g->slip, h, theta, &ignored);
        const double part =
            is_blurred(&k[i]) ? TOL_SLOW_NOISE : TOL_SLOW_MISSED;
        const double shift = shift_of(&k[i], x - k[i].x);
        const double dt =
            part * (fabs(t - k[i].time[0]) + fabs(k[i].time[1]) * shift);
        const double dl =
            part * (fabs(l - k[i].slip[0]) + fabs(k[i].slip[1]) * shift);
        k[i].time_error = fmax(k[i].time_error, dt);
        k[i + 1].time_error = fmax(k[i + 1].time_error, dt);
        k[i].slip_error = fmax(k[i].slip_error, dl);
        k[i + 1].slip_error = fmax(k[i + 1].slip_error, dl);
    }
}
