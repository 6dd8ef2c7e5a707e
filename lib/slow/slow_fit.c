/* The field's second derivatives along the curve are what is left of two terms
 * 1/gap times larger: where the rates are far apart values and slopes of three
 * knots are better. */
#include "slow_fit.h"

#include <math.h>

#include "crest.h"
#include "slider.h"
#include "slow_tolerance.h"

/* Whether rates come from a slope that is mostly noise: y' is what is left of
 * two large terms. */
static bool is_blurred(const struct slow_knot *k)
{
    return slow_knot_is_fast_y(k) && k->gap < TOL_SLOW_NOISY;
}

/* A knot with others on either side of it, and what time and slip gain on the
 * way from the one and to the other. */
struct around {
    const struct slow_knot *before, *at, *after;
    double time[2], slip[2];
};

/* Those next to it that are not much nearer than the longer of its intervals:
 * on that one, what rounding makes of a curvature is to stay rounding. */
static struct around look_around(const struct slow_branch *b, size_t i)
{
    const struct slow_knot *const k = b->knot;
    const double y = k[i].y;
    const double least =
        TOL_SLOW_AROUND * fmax(fabs(k[i + 1].y - y), fabs(y - k[i - 1].y));
    struct around a = { .at = &k[i] };
    size_t f = i, g = i;

    do {
        a.time[0] -= k[f].time[0];
        a.slip[0] -= k[f].slip[0];
    } while (--f > 0 && fabs(k[f].y - y) < least);
    do {
        g++;
        a.time[1] -= k[g].time[0];
        a.slip[1] -= k[g].slip[0];
    } while (g + 1 < b->count && fabs(k[g].y - y) < least);
    a.before = &k[f];
    a.after = &k[g];
    return a;
}

/* Of what falls by gain[] on the way, with these slopes. */
static double bend_of(const struct around *a, const double gain[2],
                      const double slope[3])
{
    const double from[3] = { gain[0], slope[0] }, at[3] = { 0.0, slope[1] },
                 to[3] = { -gain[1], slope[2] };

    return slow_knot_bend(from, at, to, a->before->y - a->at->y,
                          a->after->y - a->at->y);
}

/* The second derivatives at knot i from what lies around it. */
static void smooth_one(struct slow_branch *b, size_t i)
{
    const struct around a = look_around(b, i);
    const struct slow_knot *f = a.before, *g = a.after;
    struct slow_knot *const k = &b->knot[i];
    const double fall[] = { f->x - k->x, k->x - g->x };

    k->x_bend =
        bend_of(&a, fall, (double[3]){ f->x_slope, k->x_slope, g->x_slope });
    if (!is_blurred(k))
        return;
    k->time[2] =
        bend_of(&a, a.time, (double[3]){ f->time[1], k->time[1], g->time[1] });
    k->slip[2] =
        bend_of(&a, a.slip, (double[3]){ f->slip[1], k->slip[1], g->slip[1] });
}

/* Second derivatives of the field's slopes are mostly noise where the rates are
 * far apart. */
void slow_fit_smooth(struct slow_branch *b)
{
    struct slow_knot *const k = b->knot;
    const size_t last = b->count - 1;

    for (size_t i = 1; i < last; i++)
        if (k[i].gap < TOL_SLOW_NOISY)
            smooth_one(b, i);
    if (k[0].gap < TOL_SLOW_NOISY)
        k[0].x_bend = k[1].x_bend;
    if (k[last].gap < TOL_SLOW_NOISY)
        k[last].x_bend = k[last - 1].x_bend;
}

/* The curve between two knots. */
struct between {
    const struct block *block;
    const struct slow_knot *from, *to;
};

static double mu_between(const void *ctx, double theta)
{
    const struct between *c = ctx;
    const double y = c->from->y + theta * (c->to->y - c->from->y);
    double ignored;

    return block_mu(
        c->block,
        (struct vec2){ slow_knot_x(c->from, c->to, theta, &ignored), y });
}

/* The curve from the saddle to the first knot. */
struct start {
    const struct block *block;
    const struct saddle_series *near;
    double y;
};

static double mu_near(const void *ctx, double theta)
{
    const struct start *c = ctx;
    const double y = theta * c->y;
    double ignored;

    return block_mu(c->block,
                    (struct vec2){ saddle_series_x(c->near, y, &ignored), y });
}

void slow_fit_frictions(const struct slider *s, struct slow_branch *b)
{
    struct slow_knot *const k = b->knot;
    const struct start start = { &s->block, b->near, k->y };

    if (b->near)
        k->mu = crest_of(mu_near, &start, NULL);
    for (size_t i = 1; i < b->count; i++) {
        const struct between c = { &s->block, &k[i - 1], &k[i] };
        if (isfinite(k[i - 1].gap) && isfinite(k[i].gap))
            k[i].mu = crest_of(mu_between, &c, NULL);
    }
}

/* Of the largest friction to come, by that of each interval that may hold it.
 */
static void judge_peaks(struct slow_branch *b)
{
    double error = 0.0;

    for (size_t i = b->count - 1; i-- > 0;) {
        struct slow_knot *const k = &b->knot[i], *next = k + 1;
        const double rise = next->mu - next->mu_peak;
        error = fmax(next->mu_error + fmin(rise, 0.0), error - fmax(rise, 0.0));
        k->mu_peak_error = error = fmax(error, 0.0);
    }
}

/* What a polynomial over two steps misses at the knot between is 64 times what
 * one over one step misses; twice, if it is noise in the slopes. */
void slow_fit_judge(struct slow_branch *b, double a)
{
    struct slow_knot *const k = b->knot;
    double ignored;

    for (size_t i = 1; i + 1 < b->count; i++) {
        const struct slow_knot *f = &k[i - 1], *g = &k[i + 1];
        const double h = g->y - f->y, theta = (k[i].y - f->y) / h;
        const double x = slow_knot_x(f, g, theta, &ignored);
        const double t = slow_quintic(f->time, g->time, h, theta, &ignored);
        const double l = slow_quintic(f->slip, g->slip, h, theta, &ignored);
        const double part = is_blurred(&k[i]) ? 1.0 : TOL_SLOW_MISSED;
        const double shift = slow_knot_shift(&k[i], x - k[i].x);
        const double dt =
            part * (fabs(t - k[i].time[0]) + fabs(k[i].time[1]) * shift);
        const double dl =
            part * (fabs(l - k[i].slip[0]) + fabs(k[i].slip[1]) * shift);
        k[i].time_error = fmax(k[i].time_error, dt);
        k[i + 1].time_error = fmax(k[i + 1].time_error, dt);
        k[i].slip_error = fmax(k[i].slip_error, dl);
        k[i + 1].slip_error = fmax(k[i + 1].slip_error, dl);
        const double dmu = part * a * fabs(x - k[i].x);
        k[i].mu_error = fmax(k[i].mu_error, dmu);
        k[i + 1].mu_error = fmax(k[i + 1].mu_error, dmu);
    }
    judge_peaks(b);
}
