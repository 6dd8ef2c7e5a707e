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

/* The largest value on the step to u1, whose places err by as much as `error`
 * of it.  At corners polynomials are worse than steps: a shorter step to their
 * peak tells, and on which side of it to look again. */
static void raise_on(const struct landing *l, double h,
                     const struct explicit8 *stages, point_value *value,
                     const double u1[], double error_of, struct layer_peak *p)
{
    const struct slider *slider = l->curve->slider;
    const struct ode ode = { LAYER_DIM, landing_along, slider };
    const double tol = l->options.rtol, atol[LAYER_DIM] = { tol, tol, 1., 1. };
    struct explicit8 work = *stages;
    struct arc a = { &slider->block, value, { 0.0 } };
    double u[LAYER_DIM], end[LAYER_DIM], mid[LAYER_DIM], error[LAYER_DIM];
    double t, doubt = 0.0, seen = at_point(&a, u1);

    memcpy(u, l->u, sizeof u);
    memcpy(end, u1, sizeof end);
    for (int i = 0; i < TOL_ITERATIONS; i++) {
        explicit8_dense(&work, &ode, 0.0, u, h, end, a.coef);
        const double top = crest_of(on_arc, &a, &t);
        if (!(top > fmax(p->value, seen))) {
            layer_peak_raise(p, top, error_of);
            doubt = 0.0;
            break;
        }
        explicit8_try(&work, &ode, 0.0, u, t * h, atol, tol, mid, error);
        const double here = at_point(&a, mid);
        seen = fmax(seen, here);
        doubt = fabs(here - top);
        if (doubt <= tol)
            break;
        landing_along(slider, 0.0, mid, work.k[LAST]);
        if (is_rising(&a, mid, work.k[LAST])) {
            memcpy(u, mid, sizeof u);
            memcpy(work.k[0], work.k[LAST], sizeof work.k[0]);
            h *= 1.0 - t;
            explicit8_try(&work, &ode, 0.0, u, h, atol, tol, end, error);
        } else {
            memcpy(end, mid, sizeof end);
            h *= t;
        }
    }
    layer_peak_raise(p, seen, error_of + doubt);
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
 * of a step; mu may have one anywhere.  Rounding moves a value by what it moves
 * its place by. */
void layer_peaks_step(struct landing *l, double h, double across,
                      const struct explicit8 *stages, const double u1[],
                      const double du1[])
{
    const struct block *block = &l->curve->slider->block;
    struct layer *const out = l->out;
    const double mu0 = l->mu;
    const struct vec2 to = { u1[LAYER_X], u1[LAYER_Y] };
    const double x_error =
        TOL_LAYER_TRANSPORT * across + slider_rounding(l->curve->slider, to);
    const double mu_error = (block->steep.x + block->steep.y) * x_error;

    l->mu = block_mu(block, to);
    out->mu_next = fmax(out->mu_next, l->mu);
    layer_peak_raise(&out->mu, l->mu, mu_error);
    if (l->du[LAYER_X] > 0.0 && du1[LAYER_X] <= 0.0)
        raise_on(l, h, stages, x_of, u1, x_error, &out->x);
    if (most_on(block, mu0, l->mu, h) > out->mu.most)
        raise_on(l, h, stages, mu_of, u1, mu_error, &out->mu);
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

/* How much less than mu, the largest on the curve from y on, is to come where
 * friction is below that by `apart` at most, in each 1/fast by e times
 * less, and the curve's falls by r meanwhile: after ln(apart/r) of these it
 * lacks r (1 + ln(apart/r)). */
static double mu_lacks(const struct landing *l, const struct slow_point *p,
                       double y, double mu, double apart)
{
    const double way = -copysign(TOL_ASIDE, p->time_slope);
    const struct vec2 ahead = { p->x + way * p->x_slope, y + way };
    const double falls = fabs(mu - block_mu(&l->curve->slider->block, ahead)) +
                         TOL_ROUNDINGS_FEW * DBL_EPSILON * fabs(mu);
    const double r = 2.0 * falls / fabs(way * p->time_slope * p->fast);
    const double folds = log(apart / r);

    return folds > 0.0 && folds * p->gap < TOL_FAR_BELOW ? r * (1.0 + folds)
                                                         : apart;
}

/* The largest friction to come, which is the curve's but for *aside.  What sets
 * friction here apart from that on the curve only decays: where friction falls
 * by now, and along the curve, there is none to come; and of a peak beyond the
 * next knot, higher than all before it can be, only what is left by then.
 * Clearly below the curve's it stays below, unless the fibre turns before it is
 * there. */
static double mu_to_come(const struct landing *l, const struct slow_point *p,
                         double y, double off, double *aside)
{
    const struct block *b = &l->curve->slider->block;
    const double mu = block_mu(b, (struct vec2){ p->x, y });
    const bool is_ahead = (p->mu_y - y) * p->time_slope < 0.0;
    const double near = is_ahead ? fmax(mu, p->mu_near) : mu;
    const double apart =
        2.0 * fabs(off) *
        (b->steep.x * fabs(p->fibre.x) + b->steep.y * fabs(p->fibre.y));
    const double orbit =
        TOL_LAYER_TRANSPORT * l->across * (b->steep.x + b->steep.y);
    const bool falls = near == mu && !(p->mu_peak > mu);
    const bool is_below = mu - l->mu > fmax(TOL_SHARE * apart, orbit) &&
                          TOL_SETTLED * p->gap < 1.0;
    const double below = falls        ? mu_lacks(l, p, y, mu, apart)
                         : near == mu ? 0.0
                                      : apart;
    const double wide = orbit + (is_below ? below : apart);

    *aside = TOL_LAYER_FORGET * fabs(off) * exp(-p->mu_folds) +
             (near + wide < p->mu_peak ? 0.0 : wide);
    return falls && !mu_rises(l) ? -HUGE_VAL : fmax(near, p->mu_peak);
}

/* Where it still rises, the end of its last step may lie beyond the face. */
void layer_peaks_arrive(struct landing *l, double way, double error)
{
    const struct block *b = &l->curve->slider->block;
    const struct vec2 u = landing_place(l), du = landing_way(l);
    const struct vec2 at = { u.x + way * du.x, u.y + way * du.y };
    const double mu = block_mu(b, at);

    if (!mu_rises(l))
        return;
    if (l->out->mu.value == l->mu)
        l->out->mu.value = fmin(l->mu, mu);
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

/* Of ln v on the curve, which is as accurate as its orbit, but at the end. */
static double curve_error(const struct landing *l, const struct slow_point *p,
                          double x)
{
    const double wrong = TOL_BAR_FIRST_ORDER * TOL_REST_WRONG;

    return x == p->x_end
               ? p->x_end_error
               : wrong * (1.0 + fabs(l->curve->slider->block.at.x0 + x));
}

bool layer_peaks_land(struct landing *l, const struct slow_point *p, double y,
                      double off, double *excess)
{
    struct layer *const out = l->out;
    double aside;
    const double most = mu_to_come(l, p, y, off, &aside);
    const double part = TOL_SHARE * l->options.promise;
    const double below = x_below(out, p, off);
    const double unsure = most + aside > out->mu.value ? aside : 0.0;
    const double much = fmax(unsure / fabs(out->mu.value), below) / part;

    *excess = fmax(*excess, much);
    if (much > 1.0 && fabs(off) > TOL_LAYER_MU_TOUCH)
        return false;
    layer_peak_raise(&out->x, p->x,
                     below + TOL_LAYER_TRANSPORT * l->across +
                         curve_error(l, p, p->x));
    layer_peak_raise(&out->x, p->x_peak, below + curve_error(l, p, p->x_peak));
    layer_peak_raise(&out->mu, most, aside + p->mu_error);
    out->mu_next = fmax(out->mu_next, most);
    return true;
}
