/* In arc length of the chart an orbit off the slow curve is not stiff.  Its
 * steps are by the method of order 8 with time and slip as components.  What a
 * step may have missed is kept, with its sign, and weighed by what it makes of
 * all to come once that is known (landing_weigh).
 *
 * Step sizes follow the trend of the last two (Gustafsson, ACM TOMS 20, 1994,
 * 496-517): a fifth fewer are refused than without. */
#include "fast_layer.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "crest.h"
#include "explicit8.h"
#include "explicit8_table.h"
#include "landing.h"
#include "slider.h"
#include "slow_tolerance.h"

struct layer_options layer_defaults(double rtol)
{
    return (struct layer_options){
        .promise = rtol,
        .rtol = TOL_PART * rtol,
        .landing = rtol < TOL_COARSEST ? TOL_LAYER_CLOSER : TOL_NEARBY,
        .peaks = true,
    };
}

/* d(x, y, t, slip)/ds, s the arc length. */
static void along(const void *ctx, double s, const double u[], double du[])
{
    const struct slider *slider = ctx;
    struct planar_field f;

    (void) s;
    slider->plane.system.field(slider->plane.system.ctx,
                               (struct vec2){ u[LAYER_X], u[LAYER_Y] }, &f);
    const double x = f.direction.x, y = f.direction.y;
    const double n = sqrt(x * x + y * y);
    const double size = n > 1e-140 && n < 1e140 ? n : vec2_length(f.direction);
    du[LAYER_X] = x / size;
    du[LAYER_Y] = y / size;
    du[LAYER_TIME] = exp(-f.log_scale) / size;
    du[LAYER_SLIP] = exp(slider->block.at.x0 + u[LAYER_X]) * du[LAYER_TIME];
}

/* Per unit across an orbit, to its left: how fast it is left behind, and how
 * much longer and further an arc takes. */
struct aside {
    double spread, time, slip;
};

/* An orbit on its way. */
struct walk {
    struct landing at;
    struct ode ode;
    struct explicit8 work;
    double h;
    double previous, last; /* error and size of the last accepted step */
    bool refused;          /* the last attempt was */
    double least[2];       /* sizes that tolerances are relative to */
    struct aside aside;
    double mu; /* where it is, if peaks are asked for */
};

/* ---- steps --------------------------------------------------------------- */

enum { COEFS = EXPLICIT8_DEGREE + 1, LAST = 12 };

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

/* The largest value on the step to u1, if above what is known already; *doubt:
 * what it may lack.  At corners polynomials are worse than steps: a shorter
 * step to their peak tells, and on which side of it to look again. */
static double top_of(const struct walk *w, point_value *value,
                     const double u1[], double known, double *doubt)
{
    const struct landing *l = &w->at;
    const double tol = l->options.rtol, atol[LAYER_DIM] = { tol, tol, 1., 1. };
    struct explicit8 work = w->work;
    struct arc a = { &l->curve->slider->block, value, { 0.0 } };
    double u[LAYER_DIM], end[LAYER_DIM], mid[LAYER_DIM], error[LAYER_DIM];
    double h = w->h, t, best = fmax(known, at_point(&a, u1));

    *doubt = 0.0;
    memcpy(u, l->u, sizeof u);
    memcpy(end, u1, sizeof end);
    for (int i = 0; i < TOL_ITERATIONS; i++) {
        explicit8_dense(&work, &w->ode, 0.0, u, h, end, a.coef);
        const double top = crest_of(on_arc, &a, &t);
        if (!(top > best)) {
            *doubt = 0.0;
            break;
        }
        explicit8_try(&work, &w->ode, 0.0, u, t * h, atol, tol, mid, error);
        const double here = at_point(&a, mid);
        best = fmax(best, here);
        *doubt = fabs(here - top);
        if (*doubt <= tol)
            break;
        along(l->curve->slider, 0.0, mid, work.k[LAST]);
        if (is_rising(&a, mid, work.k[LAST])) {
            memcpy(u, mid, sizeof u);
            memcpy(work.k[0], work.k[LAST], sizeof work.k[0]);
            h *= 1.0 - t;
            explicit8_try(&work, &w->ode, 0.0, u, h, atol, tol, end, error);
        } else {
            memcpy(end, mid, sizeof end);
            h *= t;
        }
    }
    return best;
}

/* The most that friction, from mu0 to mu1, can be on an arc of length h: it
 * changes by a at most per unit of ln v, and by b of y. */
static double most_on(const struct block *b, double mu0, double mu1, double h)
{
    return 0.5 * (mu0 + mu1 + h * hypot(b->steep.x, b->steep.y));
}

/* On the step to u1: v has a peak where it rises at first and falls at last, mu
 * may have one anywhere. */
static void find_peaks(struct walk *w, const double u1[])
{
    const struct block *block = &w->at.curve->slider->block;
    struct layer *const out = w->at.out;
    const double mu0 = w->mu;
    double du1[LAYER_DIM], doubt;

    w->mu = block_mu(block, (struct vec2){ u1[LAYER_X], u1[LAYER_Y] });
    along(w->at.curve->slider, 0.0, u1, du1);
    out->x_peak = fmax(out->x_peak, u1[LAYER_X]);
    out->mu_next = fmax(out->mu_next, w->mu);
    if (w->work.k[0][LAYER_X] > 0.0 && du1[LAYER_X] <= 0.0) {
        out->x_peak = top_of(w, x_of, u1, out->x_peak, &doubt);
        out->place_error += doubt;
    }
    if (most_on(block, mu0, w->mu, w->h) > out->mu_peak) {
        out->mu_peak = top_of(w, mu_of, u1, out->mu_peak, &doubt);
        out->mu_error = fmax(out->mu_error, doubt);
    }
}

/* Whether ln v and mu fall at the start. */
static void look_ahead(const struct walk *w)
{
    const struct landing *l = &w->at;
    const struct arc mu = { &l->curve->slider->block, mu_of, { 0.0 } };
    const double back[] = { -l->du[LAYER_X], -l->du[LAYER_Y] };

    l->out->falls[0] = l->du[LAYER_X] <= 0.0;
    l->out->falls[1] =
        !is_rising(&mu, l->u, l->du) && is_rising(&mu, l->u, back);
    l->out->mu_next = -HUGE_VAL;
}

/* What changes per unit to the left of the end of the walk: beside it by less
 * than the way to the saddle, or the field there is that of other orbits. */
static struct aside look_aside(const struct landing *l)
{
    const double *du = l->du;
    const double far =
        TOL_ASIDE * fmin(fmax(fabs(l->u[LAYER_X]), fabs(l->u[LAYER_Y])), 1.0);
    const double u[LAYER_DIM] = { l->u[LAYER_X] - far * du[LAYER_Y],
                                  l->u[LAYER_Y] + far * du[LAYER_X] };
    double at[LAYER_DIM];

    along(l->curve->slider, 0.0, u, at);
    return (struct aside){
        (du[LAYER_X] * at[LAYER_Y] - du[LAYER_Y] * at[LAYER_X]) / far,
        (at[LAYER_TIME] - du[LAYER_TIME]) / far,
        (at[LAYER_SLIP] - du[LAYER_SLIP]) / far,
    };
}

/* How distances across the orbit grow on the step, as an exponent: they shrink
 * as orbits do that close in on each other at both ends of it, and grow as they
 * part in the mean of both. */
static double parting(double h, double one, double other)
{
    const double most = h * fmax(one, other), mean = 0.5 * h * (one + other);

    return fmin(fmax(fmin(most, 0.0), mean), TOL_STEP_MOST);
}

/* What the step to the end of the walk makes of what was across at its start,
 * where the direction was du0.  Off its orbit a state is also as far along as
 * the orbit turns. */
static void carry(struct walk *w, const double du0[], struct landing_step *m)
{
    const struct landing *l = &w->at;
    const double *du1 = l->du;
    const struct aside a0 = w->aside, a1 = look_aside(l);
    const double grows = parting(w->h, a0.spread, a1.spread);
    const double mean = 0.5 * (grows != 0.0 ? expm1(grows) / grows : 1.0);
    const double turn =
        du0[LAYER_X] * du1[LAYER_Y] - du0[LAYER_Y] * du1[LAYER_X];

    w->aside = a1;
    m->left = exp(grows);
    m->time_gain = mean * (w->h * (a0.time + a1.time) -
                           turn * (du0[LAYER_TIME] + du1[LAYER_TIME]));
    m->slip_gain = mean * (w->h * (a0.slip + a1.slip) -
                           turn * (du0[LAYER_SLIP] + du1[LAYER_SLIP]));
}

/* The estimates of what a step from u0 leaves out, and of what all of its terms
 * from order 4 on make. */
struct left_out {
    double term[EXPLICIT8_TERMS][LAYER_DIM], fourth[LAYER_DIM];
};

static void estimate(const struct walk *w, const double u0[],
                     struct left_out *e)
{
    const struct explicit8 *work = &w->work;

    for (int i = 0; i < LAYER_DIM; i++) {
        double third = 0.0;
        for (int j = 0; j < EXPLICIT8_STAGES; j++)
            third += explicit8_weight3[j] * work->k[j][i];
        e->fourth[i] = w->at.u[i] - u0[i] - w->h * third;
        for (int n = 0; n < EXPLICIT8_TERMS; n++) {
            e->term[n][i] = 0.0;
            for (int j = 0; j < EXPLICIT8_STAGES; j++)
                e->term[n][i] += w->h * explicit8_term[n][j] * work->k[j][i];
        }
    }
}

/* The square of the ratio in which terms fall from order to order, of two
 * components: as the one of order 7 and what both of order 6 differ by are to
 * these, and as these are to what there is from order 4 on.  unit: of the sums
 * of squares. */
static double fall_of(const struct left_out *e, int first, const double unit[])
{
    double sixth = 0.0, seventh = 0.0, apart = 0.0, fourth = 0.0;

    for (int i = first; i < first + 2; i++) {
        const double a = e->term[0][i] / unit[i], b = e->term[1][i] / unit[i];
        const double c = e->term[2][i] / unit[i], d = e->fourth[i] / unit[i];
        sixth += 0.5 * (a * a + b * b);
        seventh += c * c;
        apart += (a - b) * (a - b);
        fourth += d * d;
    }
    const double next = fmax(seventh, apart) / fmax(sixth, DBL_MIN);
    const double before = sqrt(sixth / fmax(fourth, DBL_MIN));
    return fmin(fmax(next, TOL_LAYER_FOURTH * before), TOL_LAYER_FALL);
}

/* All that the step from u0 misses; *place: of its end.  What is late because
 * it lies aside is to cancel, so one ratio is that of all. */
static void miss(const struct walk *w, const double u0[], const double unit[],
                 struct landing_step *m, double *place)
{
    const double *du = w->at.du;
    struct left_out e;

    estimate(w, u0, &e);
    const double fall =
        fmax(fall_of(&e, LAYER_X, unit), fall_of(&e, LAYER_TIME, unit));
    const double r = sqrt(fall);
    const double part = TOL_LAYER_MISSED * fall * r * (1.0 + r + fall);
    *place = 0.0;
    for (int n = 0; n < EXPLICIT8_TERMS; n++) {
        const double *t = e.term[n];
        const double on = t[LAYER_X] * du[LAYER_X] + t[LAYER_Y] * du[LAYER_Y];
        m->across[n] =
            part * (t[LAYER_Y] * du[LAYER_X] - t[LAYER_X] * du[LAYER_Y]);
        m->time[n] = part * (t[LAYER_TIME] - du[LAYER_TIME] * on);
        m->slip[n] = part * (t[LAYER_SLIP] - du[LAYER_SLIP] * on);
        *place = fmax(*place, part * (fabs(t[LAYER_X]) + fabs(t[LAYER_Y])));
    }
}

static double largest(const double of[])
{
    double most = 0.0;

    for (int n = 0; n < EXPLICIT8_TERMS; n++)
        most = fmax(most, fabs(of[n]));
    return most;
}

/* Takes the step to u1.  Rounding moves its end, and turns the field by as
 * much, relative, as its exponents are wrong. */
static void account(struct walk *w, const double u1[], const double unit[])
{
    struct landing *const l = &w->at;
    struct landing_step *const m = &l->step[l->out->steps];
    const double digit_x = TOL_ROUNDING * fabs(u1[LAYER_X]);
    const double digit_y = TOL_ROUNDING * fabs(u1[LAYER_Y]);
    const double digits = digit_x + digit_y;
    const double time = digits * fabs(u1[LAYER_TIME] - l->u[LAYER_TIME]);
    const double slip = digits * fabs(u1[LAYER_SLIP] - l->u[LAYER_SLIP]);
    double u0[LAYER_DIM], before[LAYER_DIM], place;

    memcpy(u0, l->u, sizeof u0);
    memcpy(before, l->du, sizeof before);
    memcpy(l->u, u1, sizeof l->u);
    along(l->curve->slider, 0.0, l->u, l->du);
    const double dx = fabs(l->du[LAYER_X]), dy = fabs(l->du[LAYER_Y]);
    const double on = digit_x * dx + digit_y * dy;
    carry(w, before, m);
    miss(w, u0, unit, m, &place);
    m->digits = digit_x * dy + digit_y * dx +
                TOL_SLOW_TERMS * digits * fabs(w->h) * dx * dy;
    l->across = m->left * l->across + largest(m->across) + m->digits;
    l->time_error += time + l->du[LAYER_TIME] * on;
    l->slip_error += slip + l->du[LAYER_SLIP] * on;
    l->out->place_error += place + digits;
}

/* Whether a step with this error, relative to what is allowed, is accepted;
 * *factor: what to multiply it by.  Onto the curve, and away from corners,
 * steps change like their distance: the next one by as much as the last one
 * did, if that is less than its error allows. */
static bool judge(struct walk *w, double off, double *factor)
{
    const bool good = off <= 1.0;
    const double now = fmax(off, TOL_LAYER_FLOOR);
    const double wish =
        off < HUGE_VAL ? TOL_LAYER_SAFETY * pow(now, -0.125) : 0.0;
    const double trend = fabs(w->h) / w->last * pow(w->previous / now, 0.125);
    const double next = good ? fmin(wish, wish * trend) : wish;
    const double most = good && !w->refused ? TOL_LAYER_GROWTH : 1.0;

    *factor = fmax(fmin(next, most), TOL_STEP_SHRINK);
    if (good) {
        w->previous = now;
        w->last = fabs(w->h);
    }
    w->refused = !good;
    return good;
}

/* One accepted step no longer than `most`, which may be as short as it likes;
 * false: there is none. */
static bool advance(struct walk *w, double most)
{
    struct landing *const l = &w->at;
    const double tol = l->options.rtol;
    const double atol[LAYER_DIM] = { tol, tol, tol * w->least[0],
                                     tol * w->least[1] };
    double u1[LAYER_DIM], error[LAYER_DIM], factor, off;

    w->h = fmin(w->h, most);
    for (;;) {
        off = explicit8_try(&w->work, &w->ode, 0.0, l->u, w->h, atol, tol, u1,
                            error);
        l->out->calls += EXPLICIT8_CALLS + 1;
        if (judge(w, off, &factor)) {
            if (!(l->options.peaks && landing_is_past(l, u1)))
                break;
            factor = TOL_ORBIT_RETREAT; /* or it sees peaks beyond */
        }
        w->h *= factor;
        if (!(fabs(w->h) > TOL_TOUCH))
            return false;
    }
    if (l->options.peaks)
        find_peaks(w, u1);
    for (int i = 0; i < LAYER_DIM; i++)
        error[i] = atol[i] / tol + fmax(fabs(l->u[i]), fabs(u1[i]));
    account(w, u1, error);
    w->h = fabs(w->h) * factor;
    l->out->steps++;
    return true;
}

void layer_follow(const struct slow_curve *c, struct vec2 z,
                  const struct layer_options *options, struct layer *out)
{
    struct landing_step step[TOL_LAYER_STEPS];
    struct walk w = { .at.step = step,
                      .ode = { LAYER_DIM, along, c->slider },
                      .h = TOL_NEARBY,
                      .previous = 1.0 };
    double most;

    landing_start(&w.at, c, z, options, out, w.least);
    along(c->slider, 0.0, w.at.u, w.at.du);
    w.mu = out->mu_peak;
    look_ahead(&w);
    while (!landing_is_over(&w.at, &most) && out->steps < TOL_LAYER_STEPS) {
        memcpy(w.work.k[0], w.at.du, sizeof w.at.du);
        if (!advance(&w, most))
            break;
    }
}
