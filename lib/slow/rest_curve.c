/* An orbit down to where rounding shows, and from there on what is known of its
 * end (rest_left.h). */
#include "rest_curve.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

#include "rest_form.h"
#include "rest_lag.h"
#include "rest_left.h"
#include "room.h"
#include "slider.h"
#include "slow_branch.h"
#include "slow_off.h"
#include "slow_tolerance.h"

/* ---- far down ------------------------------------------------------------ */

/* The rate psi settles at, and so on, hardly matter there; no time or slip. */
static struct rest_point point_below(const struct slider *s, double x,
                                     const struct rest_point *last)
{
    const double part = exp(x - last->x);
    const struct rest_lag l = rest_lag_at(s, x);

    return (struct rest_point){
        .x = x,
        .y = l.y,
        .y_slope = l.y_slope,
        .time_slope = l.slowness,
        .slip_slope = exp(s->block.at.x0 + x) * l.slowness,
        .fast = 1.0 / (last->gap * part * l.slowness),
        .gap = last->gap * part,
        .fibre = { last->fibre.x * part, last->fibre.y },
    };
}

static bool add_left(const struct slider *s, struct rest_point *p)
{
    const struct vec2 z = { p->x, p->y };
    struct rest_left left;

    if (!rest_left_find(s, z, 0.0, &left))
        return false;
    p->time = left.time;
    p->slip = left.slip;
    p->time_error = left.time_error;
    p->slip_error = left.slip_error;
    return true;
}

/* ---- knots --------------------------------------------------------------- */

/* At the end of the orbit, with what its last step took; false where psi does
 * not settle faster than v falls. */
static bool knot_at(const struct slider *s, const struct orbit *o,
                    struct rest_knot *k, double *bend)
{
    const struct vec2 z = { o->u[0], o->u[1] };
    struct planar_jacobian J;

    s->plane.system.jacobian(s->plane.system.ctx, z, &J);
    const struct vec2 d = J.field.direction;
    const struct eigen2 e = mat2_eigenvalues(J.matrix);
    const double slow = fmax(fabs(e.re[1]), fabs(d.x));
    const double slope = o->du[1] / o->du[0], v = exp(s->block.at.x0 + z.x);
    const double late = -1.0 / (d.x * exp(J.field.log_scale));

    *bend = (J.matrix.xx + J.matrix.xy * slope) / d.x;
    *k = (struct rest_knot){
        .at = { .x = z.x,
                .y = z.y,
                .y_slope = slope,
                .time_slope = late,
                .slip_slope = v * late,
                .fast = -e.re[0] * exp(J.field.log_scale),
                .gap = slow / -e.re[0],
                .fibre = mat2_eigenvector(J.matrix, e.re[0]) },
    };
    return e.im == 0.0 && e.re[0] < 0.0 && d.x < 0.0 &&
           k->at.gap < TOL_FAR_BELOW &&
           fabs(k->at.fibre.y) > fabs(k->at.fibre.x);
}

static enum status push(struct rest_curve *c, const struct rest_knot *k)
{
    if (ROOM_FOR(c->knot, c->room, c->count + 1))
        return STATUS_NO_MEMORY;
    c->knot[c->count++] = *k;
    return STATUS_OK;
}

/* Keeps what the orbit's last step took, and was off by, until it is known from
 * the end; *was: as of slow_off_gained. */
static enum status keep(struct rest_curve *c, const struct orbit *o,
                        struct slow_off *was, struct rest_knot *k)
{
    const double late = o->options.drift->e[0];
    const struct slow_off off = { k->at.time_slope * late,
                                  k->at.slip_slope * late };
    const struct slow_off gained = slow_off_gained(o->options.drift, off, was);

    k->at.time = slow_knot_gained(o, 2);
    k->at.slip = slow_knot_gained(o, 3 + BLOCK_SLIP);
    k->time_bar = gained.time;
    k->slip_bar = gained.slip;
    return push(c, k);
}

/* Steps that polynomials bear. */
static void hold_back(struct orbit *o, double bend)
{
    const double most = fmin(TOL_SLOW_STEP / fabs(bend), TOL_NEARBY);
    const double speed = fabs(o->du[0]);

    if (speed * o->h > most)
        o->h = most / speed;
}

/* Down to where what is left is known; false where it does not get there. */
static enum status descend(struct rest_curve *c, struct orbit *o,
                           const struct monitor *monitor, bool *is_down)
{
    const struct slider *s = c->slider;
    struct slow_off was = { 0.0, 0.0 };
    enum status status = STATUS_OK;

    *is_down = false;
    while (status == STATUS_OK && o->end == ORBIT_RUNNING &&
           o->steps < TOL_BRANCH_STEPS) {
        struct rest_knot k;
        double bend;
        if (knot_at(s, o, &k, &bend)) {
            status = keep(c, o, &was, &k);
            hold_back(o, bend);
        } else {
            c->count = 0;
        }
        struct rest_left left;
        *is_down =
            rest_left_find(s, (struct vec2){ o->u[0], o->u[1] }, 0.0, &left);
        if (*is_down || status != STATUS_OK)
            break;
        status = orbit_step(o);
        if (status == STATUS_OK && o->steps % TOL_MONITOR_STEPS == 0 &&
            monitor_tell(monitor, "rest curve", o->steps, 0))
            status = STATUS_STOPPED;
    }
    return status;
}

/* From there on without an orbit, whose steps would see rounding in psi. */
static enum status extend(struct rest_curve *c)
{
    const struct slider *s = c->slider;
    const double h = TOL_NEARBY;
    enum status status = STATUS_OK;

    while (status == STATUS_OK &&
           c->knot[c->count - 1].at.x > -TOL_SETTLED - s->block.at.x0) {
        const struct rest_knot *last = &c->knot[c->count - 1];
        const struct rest_left gone = rest_left_between(s, last->at.x, h);
        const double x = last->at.x - h;
        struct rest_knot k = { .at = point_below(s, x, &last->at) };
        k.at.time = gone.time;
        k.at.slip = gone.slip;
        k.time_bar = gone.time_error;
        k.slip_bar = gone.slip_error;
        status = push(c, &k);
    }
    return status;
}

/* ---- a whole one --------------------------------------------------------- */

/* From each step's time and slip, and what they are off, to all to come. */
static void look_back(struct rest_curve *c)
{
    const double rounded = TOL_ROUNDINGS_MANY * DBL_EPSILON;
    struct slow_sum sum = { .off = { 0.0, 0.0 } };
    struct rest_point last = c->knot[c->count - 1].at;

    if (!add_left(c->slider, &last)) {
        c->count = 0;
        return;
    }
    double time = last.time, slip = last.slip;

    for (size_t i = c->count; i-- > 0;) {
        struct rest_knot *k = &c->knot[i];
        const double dt = k->at.time, dx = k->at.slip;
        const struct slow_off bar = slow_sum_bar(&sum);
        slow_sum_add(&sum, (struct slow_off){ k->time_bar, k->slip_bar });
        k->at.time = time;
        k->at.slip = slip;
        k->time_bar = last.time_error + bar.time + rounded * time;
        k->slip_bar = last.slip_error + bar.slip + rounded * slip;
        time += dt;
        slip += dx;
    }
}

/* What falls from f[0] to g[0], with slopes and second derivatives, nearly as a
 * power of v: a polynomial's exponential. */
static double falling(const double f[3], const double g[3], double h,
                      double theta, double *slope)
{
    const double a = f[1] / f[0], b = g[1] / g[0];
    const double from[3] = { 0.0, a, f[2] / f[0] - a * a };
    const double to[3] = { log(g[0] / f[0]), b, g[2] / g[0] - b * b };
    const double value = f[0] * exp(slow_quintic(from, to, h, theta, slope));

    *slope *= value;
    return value;
}

/* Time and slip between two knots. */
static void between(const struct rest_knot *f, const struct rest_knot *g,
                    double theta, struct rest_point *p)
{
    const double h = g->at.x - f->at.x;
    const double t0[3] = { f->at.time, f->at.time_slope, f->time_bend };
    const double t1[3] = { g->at.time, g->at.time_slope, g->time_bend };
    const double x0[3] = { f->at.slip, f->at.slip_slope, f->slip_bend };
    const double x1[3] = { g->at.slip, g->at.slip_slope, g->slip_bend };

    p->time = falling(t0, t1, h, theta, &p->time_slope);
    p->slip = falling(x0, x1, h, theta, &p->slip_slope);
}

/* Of what falls nearly as a power of v: of its logarithm. */
static double falling_bend(const double f[3], const double k[3],
                           const double g[3], double before, double after)
{
    const double a = k[1] / k[0];
    const double from[3] = { log(f[0] / k[0]), f[1] / f[0] };
    const double to[3] = { log(g[0] / k[0]), g[1] / g[0] };

    return k[0] * (a * a + slow_knot_bend(from, (double[3]){ 0.0, a }, to,
                                          before, after));
}

/* By values and slopes of three knots: the field's own hold the orbit's slope,
 * and psi, which settles at once, is off its curve by what that is rounded. */
static void find_bends(struct rest_curve *c)
{
    const size_t last = c->count - 1;

    for (size_t i = 0; i < c->count; i++) {
        const struct rest_point *k = &c->knot[i].at;
        const struct rest_point *f = &c->knot[i > 0 ? i - 1 : 2].at;
        const struct rest_point *g = &c->knot[i < last ? i + 1 : last - 2].at;
        const double before = f->x - k->x, after = g->x - k->x;
        c->knot[i].y_bend = slow_knot_bend(
            (double[3]){ f->y, f->y_slope }, (double[3]){ k->y, k->y_slope },
            (double[3]){ g->y, g->y_slope }, before, after);
        c->knot[i].time_bend =
            falling_bend((double[3]){ f->time, f->time_slope },
                         (double[3]){ k->time, k->time_slope },
                         (double[3]){ g->time, g->time_slope }, before, after);
        c->knot[i].slip_bend =
            falling_bend((double[3]){ f->slip, f->slip_slope },
                         (double[3]){ k->slip, k->slip_slope },
                         (double[3]){ g->slip, g->slip_slope }, before, after);
    }
}

/* Sixth derivatives of ln T and ln X over 6!, by the knots from k[0] to k[3].
 */
static struct slow_off sixths(const struct rest_knot k[4])
{
    const struct rest_point *at[4];
    double time[4][2], slip[4][2];

    for (size_t i = 0; i < 4; i++) {
        const struct rest_point *p = at[i] = &k[i].at;
        time[i][0] = log(p->time / k[1].at.time);
        time[i][1] = p->time_slope / p->time;
        slip[i][0] = log(p->slip / k[1].at.slip);
        slip[i][1] = p->slip_slope / p->slip;
    }
    const double before = at[0]->x - at[1]->x, after = at[2]->x - at[1]->x,
                 next = at[3]->x - at[1]->x;
    return (struct slow_off){
        slow_knot_sixth(time[0], time[1], time[2], before, after, next,
                        time[3][0]),
        slow_knot_sixth(slip[0], slip[1], slip[2], before, after, next,
                        slip[3][0]),
    };
}

/* The squares of the distances that a knot's second derivatives are made over,
 * as of find_bends: they are off by f^(6)/360 times that. */
static double reach_of(const struct rest_curve *c, size_t i)
{
    const struct rest_knot *k = c->knot;
    const size_t last = c->count - 1;
    const double x = k[i].at.x;
    const double before = k[i > 0 ? i - 1 : 2].at.x - x;
    const double after = k[i < last ? i + 1 : last - 2].at.x - x;

    return before * before * after * after;
}

/* A polynomial between knots h apart, theta of the way, s = theta (1 - theta),
 * misses, by itself and by its second derivatives, which tell the other way,
 *
 *     f^(6)/6! max ((h^2 s)^3, h^2 reach s^2)
 *         <= f^(6)/6! h^2 max (h^4/64, reach/16).
 */
static void judge(struct rest_curve *c)
{
    struct rest_knot *const k = c->knot;

    for (size_t i = 0; i + 3 < c->count; i++) {
        const struct slow_off f = sixths(&k[i]);
        for (size_t j = i; j < i + 3; j++) {
            const double h = k[j + 1].at.x - k[j].at.x, square = h * h;
            const double reach = fmax(reach_of(c, j), reach_of(c, j + 1));
            const double most = TOL_BAR_FIRST_ORDER * square *
                                fmax(square * square / 64.0, reach / 16.0);
            struct rest_point *const p = &k[j].at;
            p->time_error = fmax(p->time_error, fabs(f.time) * most * p->time);
            p->slip_error = fmax(p->slip_error, fabs(f.slip) * most * p->slip);
        }
    }
}

enum status rest_curve_run(const struct slider *s, struct vec2 z,
                           const struct monitor *monitor, struct rest_curve *c)
{
    struct orbit_options options =
        orbit_defaults(&s->plane.system, s->plane.fastest_rate);
    struct drift drift;
    struct orbit o;
    bool is_down = false;

    *c = (struct rest_curve){ .slider = s };
    if (!rest_form_at(&s->block).inertial)
        return STATUS_OK;
    drift_start(&drift, slider_rounding(s, z), 0.0);
    options.drift = &drift;
    options.rtol = TOL_REST_WRONG;
    options.observables = 1;
    enum status status = orbit_init(&o, &s->plane.system, z, &options);
    if (status == STATUS_OK)
        status = descend(c, &o, monitor, &is_down);
    orbit_free(&o);
    if (!is_down || c->count < 3)
        c->count = 0;
    if (status == STATUS_OK && c->count > 0)
        status = extend(c);
    if (c->count > 3) {
        look_back(c);
        find_bends(c);
        judge(c);
    }
    return status == STATUS_NO_MEMORY || status == STATUS_STOPPED ? status
                                                                  : STATUS_OK;
}

void rest_curve_free(struct rest_curve *c)
{
    free(c->knot);
    *c = (struct rest_curve){ .slider = c->slider };
}

/* ---- points -------------------------------------------------------------- */

/* The knot before x, which is not beyond the last. */
static const struct rest_knot *before(const struct rest_curve *c, double x)
{
    size_t lo = 0, hi = c->count - 1;

    while (hi - lo > 1) {
        const size_t mid = (lo + hi) / 2;
        if (c->knot[mid].at.x >= x)
            lo = mid;
        else
            hi = mid;
    }
    return &c->knot[lo];
}

/* Between a knot and the next. */
static double y_inside(const struct rest_knot *k, double t, double *slope)
{
    const struct rest_point *f = &k[0].at, *g = &k[1].at;

    return slow_quintic((double[3]){ f->y, f->y_slope, k[0].y_bend },
                        (double[3]){ g->y, g->y_slope, k[1].y_bend },
                        g->x - f->x, t, slope);
}

bool rest_curve_beside(const struct rest_curve *c, double x, double *y,
                       double *y_slope)
{
    if (c->count < 4 || x > c->knot[0].at.x)
        return false;
    if (x < c->knot[c->count - 1].at.x) {
        const struct rest_lag l = rest_lag_at(c->slider, x);
        *y = l.y;
        *y_slope = l.y_slope;
        return true;
    }
    const struct rest_knot *f = before(c, x);
    const double t = (x - f->at.x) / (f[1].at.x - f->at.x);
    *y = y_inside(f, t, y_slope);
    return true;
}

bool rest_curve_at(const struct rest_curve *c, double x, struct rest_point *p)
{
    if (c->count < 4 || x > c->knot[0].at.x)
        return false;
    if (x < c->knot[c->count - 1].at.x) {
        *p = point_below(c->slider, x, &c->knot[c->count - 1].at);
        return add_left(c->slider, p);
    }
    const struct rest_knot *f = before(c, x), *g = f + 1;
    const double t = (x - f->at.x) / (g->at.x - f->at.x);
    *p = f->at;
    p->x = x;
    p->y = y_inside(f, t, &p->y_slope);
    p->fast += t * (g->at.fast - f->at.fast);
    p->fibre.x += t * (g->at.fibre.x - f->at.fibre.x);
    p->fibre.y += t * (g->at.fibre.y - f->at.fibre.y);
    p->time_error += f->time_bar;
    p->slip_error += f->slip_bar;
    between(f, g, t, p);
    return true;
}
