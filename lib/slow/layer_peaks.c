/* On a step's polynomial (explicit8.h): its further stages, and the shorter
 * steps that judge it, are of one orbit alone. */
#include "layer_peaks.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "crest.h"
#include "explicit8_table.h"
#include "landing_halves.h"
#include "slider.h"
#include "slow_tolerance.h"

enum { COEFS = EXPLICIT8_DEGREE + 1, LAST = EXPLICIT8_STAGES };

/* A number of a point of the orbit. */
typedef double point_value(const struct block *b, struct vec2 z);

static double x_of(const struct block *b, struct vec2 z)
{
    (void) b;
    return z.x;
}

static double mu_of(const struct block *b, struct vec2 z)
{
    return block_mu(b, z);
}

/* A step's polynomial. */
struct arc {
    const struct block *block;
    point_value *value;
    double coef[LAYER_DIM * COEFS];
};

static double on_arc(const void *ctx, double t)
{
    const struct arc *a = ctx;
    const double *c = a->coef;
    struct vec2 z = { 0.0, 0.0 };

    for (int j = COEFS; j-- > 0;)
        z = (struct vec2){ z.x * t + c[j], z.y * t + c[COEFS + j] };
    return a->value(a->block, z);
}

static double at_point(const struct arc *a, const double u[])
{
    return a->value(a->block, (struct vec2){ u[LAYER_X], u[LAYER_Y] });
}

/* Whether it rises along the orbit. */
static bool is_rising(const struct arc *a, const double u[], const double du[])
{
    const double ahead[2] = { u[LAYER_X] + TOL_ASIDE * du[LAYER_X],
                              u[LAYER_Y] + TOL_ASIDE * du[LAYER_Y] };

    return at_point(a, ahead) > at_point(a, u);
}

/* Where the value is largest on the step to u1, if that is neither there, where
 * it `rises`, nor more than is known: at corners polynomials are worse than
 * steps, and a shorter step to their peak tells, and on which side of it to
 * look again.  False: it is not. */
static bool crest_on(const struct landing *l, double h,
                     const struct explicit8 *stages, struct arc *a,
                     const double u1[], bool rises, double known, double *top)
{
    const struct ode ode = { LAYER_DIM, landing_along, l->curve->slider };
    const double unit[LAYER_DIM] = { 1.0, 1.0, 1.0, 1.0 };
    struct explicit8 work = *stages;
    double u[LAYER_DIM], end[LAYER_DIM], mid[LAYER_DIM], error[LAYER_DIM];
    double t, seen = fmax(known, at_point(a, u1));

    memcpy(u, l->u, sizeof u);
    memcpy(end, u1, sizeof end);
    explicit8_dense(&work, &ode, 0.0, u, h, end, a->coef);
    *top = crest_of(on_arc, a, &t);
    if (rises && t == 1.0)
        return false;
    for (int i = 0; i < TOL_ITERATIONS && crest_of(on_arc, a, &t) > seen; i++) {
        explicit8_try(&work, &ode, 0.0, u, t * h, unit, 0.0, mid, error);
        const double here = at_point(a, mid);
        *top = i == 0 || here > seen ? here : *top;
        seen = fmax(seen, here);
        landing_along(l->curve->slider, 0.0, mid, work.k[LAST]);
        if (is_rising(a, mid, work.k[LAST])) {
            memcpy(u, mid, sizeof u);
            memcpy(work.k[0], work.k[LAST], sizeof work.k[0]);
            h *= 1.0 - t;
            explicit8_try(&work, &ode, 0.0, u, h, unit, 0.0, end, error);
        } else {
            memcpy(end, mid, sizeof end);
            h *= t;
        }
        explicit8_dense(&work, &ode, 0.0, u, h, end, a->coef);
    }
    return true;
}

/* The largest value on the step to u1, whose places err by as much as `error`
 * of it: at a corner no less than steps are off. */
static void raise_on(const struct landing *l, double h,
                     const struct explicit8 *stages, point_value *value,
                     const double u1[], bool rises, double error,
                     struct layer_peak *p)
{
    struct arc a = { &l->curve->slider->block, value, { 0.0 } };
    double top;

    if (crest_on(l, h, stages, &a, u1, rises, p->value, &top))
        layer_peak_raise(p, top, error);
}

/* The most that friction, from mu0 to mu1, can be on an arc of length h: it
 * changes by a at most per unit of ln v, and by b of y. */
static double most_on(const struct block *b, double mu0, double mu1, double h)
{
    return 0.5 * (mu0 + mu1 + h * hypot(b->steep.x, b->steep.y));
}

void layer_peaks_start(struct landing *l)
{
    const struct arc mu = { &l->curve->slider->block, mu_of, { 0.0 } };
    const double back[] = { -l->du[LAYER_X], -l->du[LAYER_Y] };

    l->out->falls[0] = l->du[LAYER_X] <= 0.0;
    l->out->falls[1] =
        !is_rising(&mu, l->u, l->du) && is_rising(&mu, l->u, back);
    l->out->mu_next = -HUGE_VAL;
}

void layer_peak_raise(struct layer_peak *p, double value, double error)
{
    if (value > p->value) {
        p->value = value;
        p->error = error;
    }
    p->most = fmax(p->most, value + error);
}

double layer_peak_error(const struct layer_peak *p)
{
    return fmax(p->error, p->most - p->value);
}

/* v has a peak where it rises at first and falls at last, and none at the end
 * of a step; mu may have one anywhere, but where it rises at the end of a step
 * what comes is more.  Rounding moves a value by what it moves its place by. */
void layer_peaks_step(struct landing *l, double h, double across,
                      const struct explicit8 *stages, const double u1[],
                      const double du1[])
{
    const struct block *block = &l->curve->slider->block;
    const struct arc arc = { block, mu_of, { 0.0 } };
    struct layer *const out = l->out;
    const double mu0 = l->mu, steep = block->steep.x + block->steep.y;
    const struct vec2 to = { u1[LAYER_X], u1[LAYER_Y] };
    const double rounding = slider_rounding(l->curve->slider, to);
    const double most = TOL_LAYER_TRANSPORT * across + rounding;
    const double at_end = steep * (TOL_LAYER_TRANSPORT * l->across + rounding);
    const bool rises = is_rising(&arc, u1, du1);

    l->mu = block_mu(block, to);
    out->mu_next = fmax(out->mu_next, l->mu);
    l->mu_least = fmax(l->mu_least, l->mu - at_end);
    if (!rises)
        layer_peak_raise(&out->mu, l->mu, at_end);
    if (l->du[LAYER_X] > 0.0 && du1[LAYER_X] <= 0.0)
        raise_on(l, h, stages, x_of, u1, false, most, &out->x);
    if (most_on(block, mu0, l->mu, h) + steep * most > l->mu_least)
        raise_on(l, h, stages, mu_of, u1, rises, steep * most, &out->mu);
}

/* ---- to come ------------------------------------------------------------- */

/* Whether friction rises from here on, or by less than is seen. */
static bool mu_rises(const struct landing *l)
{
    const struct block *b = &l->curve->slider->block;
    const struct vec2 z = landing_place(l), dz = landing_way(l);
    const struct vec2 ahead = { z.x + TOL_ASIDE * dz.x,
                                z.y + TOL_ASIDE * dz.y };

    return block_mu(b, ahead) >= block_mu(b, z);
}

/* A point of the curve on the fibre of where it landed, `off` along it; how far
 * along the curve that is off, in y, by what the orbit is. */
struct foot {
    const struct slow_point *p;
    double y, off, shift;
    double mu, mu_slope; /* of friction, there and per unit of y, with what
                            rounding makes of that */
};

static struct foot foot_at(const struct landing *l, const struct slow_point *p,
                           double y, double off)
{
    const struct block *b = &l->curve->slider->block;
    const double way = -copysign(TOL_ASIDE, p->time_slope);
    const struct vec2 ahead = { p->x + way * p->x_slope, y + way };
    const double mu = block_mu(b, (struct vec2){ p->x, y });
    const double falls = fabs(mu - block_mu(b, ahead)) +
                         TOL_ROUNDINGS_FEW * DBL_EPSILON * fabs(mu);
    const double det = fabs(p->fibre.x - p->fibre.y * p->x_slope);

    return (struct foot){ p,   y,
                          off, TOL_LAYER_TRANSPORT * l->across / det,
                          mu,  falls / TOL_ASIDE };
}

/* How much less than mu, the largest on the curve from y on, is to come where
 * friction is below that by `apart` at most, in each 1/fast by e times
 * less, and the curve's falls by r meanwhile: after ln(apart/r) of these it
 * lacks r (1 + ln(apart/r)). */
static double mu_lacks(const struct foot *f, double apart)
{
    const double r = 2.0 * f->mu_slope / fabs(f->p->time_slope * f->p->fast);
    const double folds = log(apart / r);

    return folds > 0.0 && folds * f->p->gap < TOL_FAR_BELOW ? r * (1.0 + folds)
                                                            : apart;
}

/* How far what is to come on the interval is from `near`, the curve's there.
 * Clearly below the curve's friction stays below, but for what the orbit is
 * off, unless the fibre turns before it is there. */
static double mu_aside(const struct landing *l, const struct foot *f,
                       double near, bool falls)
{
    const struct slow_point *p = f->p;
    const struct vec2 m = l->curve->slider->block.steep;
    const double beside = TOL_LAYER_TRANSPORT * l->across * (m.x + m.y);
    const double apart =
        2.0 * fabs(f->off) * (m.x * fabs(p->fibre.x) + m.y * fabs(p->fibre.y)) +
        beside;
    const double along = (f->mu_slope + (m.x + m.y) * f->shift) * f->shift;
    const double lies = f->mu - l->mu;
    const bool is_below =
        lies > TOL_SHARE * apart && TOL_SETTLED * p->gap < 1.0;
    const double below = falls           ? mu_lacks(f, apart)
                         : near == f->mu ? 0.0
                                         : apart;

    return along + (is_below ? below + fmax(beside - lies, 0.0) : apart);
}

/* Friction to come, with what it is off: on the interval, and beyond the next
 * knot.  What sets friction here apart from that on the curve only decays:
 * where friction falls by now, and along the curve, there is none to come; and
 * of a peak beyond the next knot only what is left by then. */
struct to_come {
    double near, near_error, far, far_error;
};

static struct to_come mu_to_come(const struct landing *l, const struct foot *f)
{
    const struct slow_point *p = f->p;
    const bool is_ahead = (p->mu_y - f->y) * p->time_slope < 0.0;
    const double near = is_ahead ? fmax(f->mu, p->mu_near) : f->mu;
    const bool falls = near == f->mu && !(p->mu_peak > f->mu);

    if (falls && !mu_rises(l))
        return (struct to_come){ -HUGE_VAL, 0.0, -HUGE_VAL, 0.0 };
    return (struct to_come){
        near,
        mu_aside(l, f, near, falls),
        p->mu_peak,
        TOL_LAYER_FORGET * fabs(f->off) * exp(-p->mu_folds),
    };
}

/* What is not known of friction that may be the largest. */
static double unsure_of(const struct to_come *c, double most)
{
    const double near =
        c->near + c->near_error > fmax(most, c->far) ? c->near_error : 0.0;
    const double far = c->far + c->far_error > most ? c->far_error : 0.0;

    return fmax(near, far);
}

void layer_peaks_arrive(struct landing *l, double way, double error)
{
    const struct block *b = &l->curve->slider->block;
    const struct vec2 u = landing_place(l), du = landing_way(l);
    const struct vec2 at = { u.x + way * du.x, u.y + way * du.y };
    const double mu = block_mu(b, at);

    if (!mu_rises(l))
        return;
    layer_peak_raise(&l->out->mu, mu,
                     (b->steep.x + b->steep.y) *
                         (error + slider_rounding(l->curve->slider, at)));
}

/* How much faster the block may become than is known: as fast as on the curve,
 * where that leads down from here; else by what is left beside its peak. */
static double x_below(const struct layer *out, const struct slow_point *p,
                      double off)
{
    return p->x_peak > p->x ? TOL_LAYER_FORGET * fabs(off) * exp(-p->x_folds)
                            : fmax(p->x - out->x.value, 0.0);
}

/* Of ln v that is largest ahead on the curve, which is as accurate as its
 * orbit, but at the end. */
static double x_ahead_error(const struct landing *l, const struct slow_point *p)
{
    const double wrong = TOL_BAR_FIRST_ORDER * TOL_REST_WRONG;

    return p->x_peak == p->x_end
               ? p->x_end_error
               : wrong *
                     (1.0 + fabs(l->curve->slider->block.at.x0 + p->x_peak));
}

/* Of ln v on the curve where it lands: by what the curve is aside, along the
 * fibre, and by its place on it. */
static double x_error(const struct landing *l, const struct foot *f)
{
    const struct slow_point *p = f->p;
    const double det = p->fibre.x - p->fibre.y * p->x_slope;

    return fabs(p->fibre.x / det) * p->aside +
           (fabs(p->x_slope) + f->shift) * f->shift +
           slider_rounding(l->curve->slider, (struct vec2){ p->x, f->y });
}

bool layer_peaks_land(struct landing *l, const struct slow_point *p, double y,
                      double off, double *excess)
{
    struct layer *const out = l->out;
    const struct foot f = foot_at(l, p, y, off);
    const struct to_come mu = mu_to_come(l, &f);
    const double largest = fmax(out->mu.value, fmax(mu.near, mu.far));
    const double part = TOL_SHARE * l->options.promise;
    const double below = x_below(out, p, off);
    const double unsure = unsure_of(&mu, out->mu.value);
    const double much = fmax(unsure / fabs(largest), below) / part;

    *excess = fmax(*excess, much);
    if (much > 1.0 && fabs(off) > TOL_LAYER_MU_TOUCH)
        return false;
    layer_peak_raise(&out->x, p->x, below + x_error(l, &f));
    layer_peak_raise(&out->x, p->x_peak, below + x_ahead_error(l, p));
    layer_peak_raise(&out->mu, mu.near, mu.near_error + p->mu_error);
    layer_peak_raise(&out->mu, mu.far, mu.far_error + p->mu_peak_error);
    out->mu_next = fmax(out->mu_next, fmax(mu.near, mu.far));
    return true;
}
