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
        TOL_SHARE * fmax(fabs(k[i + 1].y - y), fabs(y - k[i - 1].y));
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

/* How far a fibre is turned from its eigenvector, and how far off that is. */
struct lag {
    double angle, wrong;
};

/* What turns within one fold on the way from f to k. */
static double turning(const struct slow_knot *f, const struct slow_knot *k)
{
    const double turns = f->fibre.x * k->fibre.y - f->fibre.y * k->fibre.x;

    return isfinite(f->gap) && isfinite(k->gap) && k->time[0] < 0.0
               ? 0.5 * (f->fold + k->fold) * turns / -k->time[0]
               : 0.0;
}

/* From g to the knot k before it, where `turn`, first and last, is what turns
 * within a fold: evenly more or less of it on the way.  What it `changes` by is
 * not known, the less so in between; nor is what is not linear. */
static struct lag lag_before(const struct slow_knot *k,
                             const struct slow_knot *g, const double turn[2],
                             const double changes[2], struct lag l)
{
    const double det =
        fabs(k->fibre.x - k->fibre.y * k->x_slope) / hypot(1.0, k->x_slope);
    const double folds = -g->time[0] / k->fold, left = exp(-folds);
    const double ahead = folds > 0.0 ? (turn[1] - turn[0]) / folds : 0.0;

    return (struct lag){
        turn[0] + ahead + left * (l.angle - turn[1] - ahead),
        left * l.wrong + (1.0 + 0.25 * folds) * fmax(changes[0], changes[1]) +
            0.125 * TOL_SLOW_STEP * folds * fabs(turn[0]) +
            turn[0] * turn[0] / det,
    };
}

void slow_fit_fibres(struct slow_branch *b)
{
    struct slow_knot *const k = b->knot;
    const size_t last = b->count - 1;
    double after = turning(&k[last - 1], &k[last]), turn[2] = { after, after };
    double changes[2] = { 0.0, 0.0 };
    struct lag lag = { after, fabs(after) };

    for (size_t i = b->count; i-- > 0;) {
        const struct vec2 e = k[i].fibre;
        const double before = i > 0 ? turning(&k[i - 1], &k[i]) : after;
        turn[0] = 0.5 * (before + after);
        changes[0] = fabs(after - before);
        if (!isfinite(k[i].gap))
            lag = (struct lag){ 0.0, 1.0 };
        else if (i < last)
            lag = lag_before(&k[i], &k[i + 1], turn, changes, lag);
        k[i].fibre =
            (struct vec2){ e.x - lag.angle * e.y, e.y + lag.angle * e.x };
        k[i].swing = lag.wrong;
        turn[1] = turn[0];
        changes[1] = changes[0];
        after = before;
    }
}

/* On a polynomial x = q(y) from one knot to the next, the field's x' - q' y'
 * and how fast what is beside it falls, q' dy'/dx - dx'/dx: the most of the
 * one, and the least of the other. */
struct defect {
    double most, fall;
};

static struct defect defect_of(const struct slider *s,
                               const struct slow_knot *f,
                               const struct slow_knot *g)
{
    enum { PARTS = 4 };
    struct defect d = { 0.0, HUGE_VAL };

    for (int i = 0; i <= PARTS; i++) {
        const double t = (double) i / PARTS;
        struct planar_jacobian J;
        double q;
        const double x = slow_knot_x(f, g, t, &q), y = f->y + t * (g->y - f->y);
        s->plane.system.jacobian(s->plane.system.ctx, (struct vec2){ x, y },
                                 &J);
        const struct vec2 z = J.field.direction;
        const double scale = exp(J.field.log_scale);
        d.most = fmax(d.most, scale * fabs(z.x - q * z.y));
        d.fall = fmin(d.fall, scale * (q * J.matrix.yx - J.matrix.xx));
    }
    return d;
}

/* What an orbit that is e beside the polynomial is beside it a time t later,
 * for e' = rho - r e, |rho| <= most, r >= fall, to first order:
 *     |e| exp(-r t) + |rho| (1 - exp(-r t))/r. */
static double beside_after(const struct defect *d, double t, double e)
{
    const double folds = d->fall * t;
    const double gain = folds != 0.0 ? -expm1(-folds) / d->fall : t;

    return e * exp(-folds) + TOL_BAR_FIRST_ORDER * d->most * gain;
}

void slow_fit_places(const struct slider *s, struct slow_branch *b)
{
    struct slow_knot *const k = b->knot;
    double off = b->near ? TOL_ROUNDED * fabs(k->x) : 0.0;

    k->aside = off;
    for (size_t i = 1; i < b->count; i++) {
        const struct slow_knot *f = &k[i - 1];
        const double least =
            TOL_REST_WRONG * (1.0 + fabs(s->block.at.x0 + k[i].x));
        const double before = off;
        const struct defect d = defect_of(s, f, &k[i]);
        off = beside_after(&d, -k[i].time[0], before);
        if (!isfinite(f->gap) || !isfinite(k[i].gap) || !isfinite(off))
            off = TOL_BAR_FIRST_ORDER *
                  (fmax(fabs(f->beside), fabs(k[i].beside)) + least);
        k[i].aside = fmax(before, off);
    }
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

/* How far off friction is where the place is. */
static double mu_aside(const struct slider *s, struct vec2 aside)
{
    return s->block.steep.x * fabs(aside.x) + s->block.steep.y * fabs(aside.y);
}

/* The peaks to come, and what settles on the way to them: at the end of one
 * that is aside there, friction anywhere on its interval. */
static void look_for_peaks(const struct slider *s, struct slow_branch *b)
{
    struct slow_knot to = { .x_peak = -HUGE_VAL, .mu_peak = -HUGE_VAL };
    struct vec2 aside = b->end_aside;

    for (size_t i = b->count; i-- > 0;) {
        struct slow_knot *k = &b->knot[i];
        const struct slow_knot *before = &k[i > 0 ? -1 : 0];
        const double folds = -k->time[0] * fmin(before->fast, k->fast);
        if (k->x > to.x_peak) {
            to.x_peak = k->x;
            to.x_folds = -log(fabs(aside.x));
        }
        k->x_peak = to.x_peak;
        k->mu_peak = to.mu_peak;
        k->folds = to.folds;
        k->x_folds = to.x_folds;
        k->mu_folds = to.mu_folds;
        to.folds += folds;
        to.x_folds += folds;
        to.mu_folds += folds;
        if (k->mu > to.mu_peak) {
            to.mu_peak = k->mu;
            to.mu_folds =
                -log(fmax(mu_aside(s, aside), mu_aside(s, before->fibre)));
        }
        aside = before->fibre;
    }
}

void slow_fit_frictions(const struct slider *s, struct slow_branch *b)
{
    struct slow_knot *const k = b->knot;
    const struct start start = { &s->block, b->near, k->y };

    double at;

    if (b->near) {
        k->mu = crest_of(mu_near, &start, &at);
        k->mu_y = at * k->y;
    }
    for (size_t i = 1; i < b->count; i++) {
        const struct between c = { &s->block, &k[i - 1], &k[i] };
        if (isfinite(k[i - 1].gap) && isfinite(k[i].gap)) {
            k[i].mu = crest_of(mu_between, &c, &at);
            k[i].mu_y = c.from->y + at * (c.to->y - c.from->y);
        }
    }
    look_for_peaks(s, b);
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

/* What rounding of y, of which slopes and curvatures of knots are made where y
 * settles first, makes of x in the middle between two that are h apart, per
 * unit of its slope; of time and slip as much.  y' is wrong by r = fast
 * digit/|y'| of itself and the curvature by fast r/|y'| slopes: h r (10 + h
 * fast/|y'|)/32 for both knots, by the weights 5 h/32 and h^2/64 of a quintic.
 */
static double rounding_of(const struct slider *s, const struct slow_knot *k,
                          double h)
{
    const double shrinks = k->fast * fabs(k->time[1]);
    const double r = shrinks * slider_rounding(s, (struct vec2){ k->x, k->y });

    return slow_knot_is_fast_y(k) ? h * r * (10.0 + h * shrinks) / 32.0 : 0.0;
}

/* Of a number at both ends of an interval. */
static void widen(double *from, double *to, double error)
{
    *from = fmax(*from, error);
    *to = fmax(*to, error);
}

/* Of both intervals at a knot where a polynomial over both misses that: 64
 * times what one over one step misses in its middle; but as much, at most, is
 * noise of the slopes. */
static void widen_both(struct slow_miss *before, struct slow_miss *after,
                       double missed, double noise)
{
    const double part = TOL_SLOW_MISSED * missed;

    widen(&before->missed, &after->missed, part);
    widen(&before->rounded, &after->rounded, fmin(noise, missed - part));
}

/* What friction is off where the curve is `aside` in x, or as much in y as its
 * slope makes of that: of its largest value the less of both, at the end, a
 * face of either coordinate, the more. */
static void judge_friction(const struct slider *s, struct slow_branch *b)
{
    const struct vec2 m = s->block.steep;
    const size_t last = b->count - 1;

    for (size_t i = 0; i <= last; i++) {
        struct slow_knot *const k = &b->knot[i], *before = &k[i > 0 ? -1 : 0];
        const double steep = fmin(fabs(before->x_slope), fabs(k->x_slope));
        const double per_y = m.y / steep;
        const double per =
            i < last ? fmin(m.x, per_y) : fmax(m.x, fmin(m.y, per_y));
        k->mu_error = per * k->aside +
                      TOL_SLOW_TERMS * (m.x + m.y) *
                          slider_rounding(s, (struct vec2){ k->x, k->y });
    }
}

void slow_fit_judge(const struct slider *s, struct slow_branch *b)
{
    struct slow_knot *const k = b->knot;
    double ignored;

    for (size_t i = 1; i + 1 < b->count; i++) {
        const struct slow_knot *f = &k[i - 1], *g = &k[i + 1];
        const double h = g->y - f->y, theta = (k[i].y - f->y) / h;
        const double x = slow_knot_x(f, g, theta, &ignored) - k[i].x;
        const double t = slow_quintic(f->time, g->time, h, theta, &ignored);
        const double l = slow_quintic(f->slip, g->slip, h, theta, &ignored);
        const double noise = rounding_of(s, &k[i], 0.5 * fabs(h));
        const double shift = slow_knot_shift(&k[i], x);
        const double time = fabs(k[i].time[1]), slip = fabs(k[i].slip[1]);
        widen_both(&k[i].time_miss, &k[i + 1].time_miss,
                   fabs(t - k[i].time[0]) + time * shift, time * noise);
        widen_both(&k[i].slip_miss, &k[i + 1].slip_miss,
                   fabs(l - k[i].slip[0]) + slip * shift, slip * noise);
    }
    judge_friction(s, b);
    judge_peaks(b);
}

void slow_fit_digits(struct slow_branch *b)
{
    double time = 0.0, slip = 0.0;

    for (size_t i = 0; i < b->count; i++) {
        const bool from_first = b->start == SLOW_FACE;
        struct slow_knot *const k = &b->knot[from_first ? i : b->count - 1 - i];
        const double off = slow_knot_digit(k);
        k->time_bar += TOL_DRIFT_NOISE * time;
        k->slip_bar += TOL_DRIFT_NOISE * slip;
        time = hypot(time, k->time[1] * off);
        slip = hypot(slip, k->slip[1] * off);
    }
}
