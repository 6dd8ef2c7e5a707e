/*
 * Start: so near to the saddle that the field runs along the stable eigenvector
 * and integrals grow with the distance, to a part a with a^2 below a step's
 * tolerance.  What is missed there is a of the distance, which is a of what the
 * branch bends over; and backward in time orbits close in on the manifold.
 * Steps: orbit.h, offsets relative to where it is, errors carried by drift.h.
 * End: backward_end.h; what is left is added and counts as error.
 */
#include "backward.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "backward_end.h"
#include "backward_tolerance.h"
#include "limit.h"
#include "orbit.h"
#include "stretched.h"
#include "tolerance.h"

enum { ATTEMPTS = 60 };

struct backward_options backward_defaults(double rtol)
{
    return (struct backward_options){ .rtol = rtol,
                                      .max_steps = TOL_ORBIT_STEPS };
}

/* A branch on its way. */
struct route {
    struct backward_way way;
    const struct backward_options *options;
    double tol, kappa;
    double rate[PLANAR_OBSERVABLES_MAX]; /* units of integrals */
    struct stretched units;
    struct orbit orbit;            /* owned; in those units */
    struct drift drift;            /* of the orbit, from the start on */
    struct vec2 start;             /* of the orbit */
    double first[LOCAL_CARRY_MAX]; /* integrals there */
    double off[LOCAL_CARRY_MAX];   /* of the first of these */
    struct branch *out;            /* with what is behind the orbit */
    double beside;                 /* bound on how far off it is */
    int ind;                       /* the coordinate it ends along */
    struct backward_rest rest;     /* what the end added */
};

/* That of the orbit which has integral i; and the unit of one. */
static size_t component(const struct route *r, size_t i)
{
    const int which = r->way.carry->which[i];

    return which == CARRY_TIME ? 2 : 3 + (size_t) which;
}

static double unit_of(const struct route *r, size_t i)
{
    return i == 0   ? r->units.unit.x
           : i == 1 ? r->units.unit.y
           : i == 2 ? 1.0
                    : r->rate[i - 3];
}

static double total_at(const struct route *r, size_t i)
{
    const size_t k = component(r, i);

    return r->first[i] + unit_of(r, k) * r->orbit.u[k];
}

static struct vec2 place(const struct route *r)
{
    return stretched_offset(&r->units, r->orbit.u);
}

/* ---- start --------------------------------------------------------------- */

/* The part by which at r->start = reach d the field is off its way along -d,
 * in each coordinate, and integrals are off growing by r->first[] over this way
 * as over its first half: both grow like reach.  Infinite where the field does
 * not come in. */
static double bend(struct route *r, struct vec2 d, double reach)
{
    const struct planar *sys = r->way.sys;
    const double less = fmin(fabs(d.x), fabs(d.y));
    const double thin = less > 0.0 ? less : 1.0;
    double half[LOCAL_CARRY_MAX], worst = 0.0;

    for (int i = 0; i < 2; i++) {
        const double far = i == 0 ? 0.5 * reach : reach;
        struct planar_field f;
        r->start = vec2_scale(far, d);
        sys->field(sys->ctx, r->start, &f);
        const double along = f.direction.x * d.x + f.direction.y * d.y;
        const double beside = f.direction.y * d.x - f.direction.x * d.y;
        if (!(along < 0.0))
            return HUGE_VAL;
        worst = fmax(worst, fabs(beside / along) / thin);
        for (size_t k = 0; k < r->way.carry->count; k++) {
            const double rate =
                r->way.converges[k]
                    ? backward_rate(&r->way, k, r->start, f.log_scale)
                    : 0.0;
            *(i == 0 ? &half[k] : &r->first[k]) = rate * (reach / along);
        }
    }
    for (size_t k = 0; k < r->way.carry->count; k++)
        if (r->first[k] != half[k])
            worst = fmax(worst, fabs(1.0 - half[k] / r->first[k]));
    return worst;
}

static bool find_start(struct route *r, struct vec2 d)
{
    const double enough = sqrt(r->tol);
    double reach = TOL_SERIES_RADIUS_MAX;

    for (int i = 0; i < ATTEMPTS; i++) {
        const double off = bend(r, d, reach);
        if (off <= enough) {
            drift_start(&r->drift, off, 0.0);
            for (size_t k = 0; k < PLANAR_OBSERVABLES_MAX; k++)
                r->rate[k] = 1.0;
            for (size_t k = 0; k < r->way.carry->count; k++) {
                r->off[k] = off * fabs(r->first[k]);
                if (fabs(r->first[k]) > 0.0 && component(r, k) > 2)
                    r->rate[component(r, k) - 3] = fabs(r->first[k]);
            }
            r->beside = off * vec2_length(r->start);
            return true;
        }
        reach *= 0.5 * enough / fmin(off, 1.0);
    }
    return false;
}

/* An orbit from r->start on, in units of where that is. */
static enum status begin(struct route *r)
{
    const double size = vec2_length(r->start);
    const double x = fabs(r->start.x), y = fabs(r->start.y);
    const struct vec2 unit = { x > DBL_MIN ? x : size, y > DBL_MIN ? y : size };

    stretched_init(&r->units, r->way.sys, unit, r->rate);
    struct orbit_options o = orbit_defaults(&r->units.planar, r->kappa);
    o.rtol = r->tol;
    o.backward = o.far = true;
    o.drift = &r->drift;
    o.max_steps = r->options->max_steps;
    for (size_t i = 0; i <= o.observables; i++)
        o.least[i] = TOL_RANGE; /* of those that nobody asked for */
    for (size_t i = 0; i < r->way.carry->count; i++)
        o.least[component(r, i) - 2] =
            fabs(r->first[i]) / unit_of(r, component(r, i));
    return orbit_init(&r->orbit, &r->units.planar,
                      (struct vec2){ r->start.x / unit.x, r->start.y / unit.y },
                      &o);
}

/* ---- pieces -------------------------------------------------------------- */

/* From the saddle to the orbit, straight. */
static enum status add_start(const struct route *r)
{
    struct curve *c = &r->out->curve;
    double *to;
    const enum status s = curve_push(c, 1, &to);

    if (s != STATUS_OK)
        return s;
    memset(to, 0, 2 * c->dim * sizeof *to);
    to[1] = r->start.x;
    to[3] = r->start.y;
    for (size_t i = 0; i < r->way.carry->count; i++)
        to[2 * i + 5] = r->first[i];
    c->piece[0].error = r->beside;
    return STATUS_OK;
}

/* Component i of the branch over a piece of n coefficients of the orbit. */
static void copy_component(const struct route *r, size_t piece, size_t i,
                           size_t n, double to[])
{
    const size_t k = i < 2 ? i : component(r, i - 2);
    const double *from = curve_component(&r->orbit.curve, piece, k);

    for (size_t j = 0; j < n; j++)
        to[j] = unit_of(r, k) * from[j];
    to[0] += i < 2 ? 0.0 : r->first[i - 2];
}

/* The orbit becomes part of the branch. */
static enum status add_orbit(struct route *r)
{
    const struct orbit *o = &r->orbit;
    struct branch *b = r->out;
    double *to;
    enum status s = STATUS_OK;

    for (size_t k = 0; k < o->curve.count && s == STATUS_OK; k++) {
        const size_t n = o->curve.piece[k].degree + 1;
        s = curve_push(&b->curve, n - 1, &to);
        for (size_t i = 0; i < b->curve.dim && s == STATUS_OK; i++)
            copy_component(r, k, i, n, to + i * n);
        if (s == STATUS_OK)
            b->curve.piece[b->curve.count - 1].error = o->curve.piece[k].error;
    }
    b->steps += o->steps;
    b->rejected += o->rejected;
    b->evaluations += o->field_calls + o->jacobian_calls;
    return s;
}

/* Goes on in units of where the orbit is. */
static enum status change_units(struct route *r)
{
    const struct vec2 old = r->units.unit;
    struct drift *d = &r->drift;
    enum status s = add_orbit(r);

    for (size_t i = 0; i < r->way.carry->count; i++)
        r->first[i] = total_at(r, i);
    r->start = place(r);
    orbit_free(&r->orbit);
    if (s == STATUS_OK)
        s = begin(r);
    for (int k = 0; k < 2; k++) {
        const double part =
            k == 0 ? old.x / r->units.unit.x : old.y / r->units.unit.y;
        d->e[k] *= part;
        d->lost[k] *= part;
        for (int i = 0; i < CURVE_DIM_MAX; i++) {
            d->noise[k][i] *= part;
            d->noise[i][k] *= part;
        }
    }
    return s;
}

/* ---- steps --------------------------------------------------------------- */

/* Ends the route where what is left is below a part. */
static bool settle(struct route *r, const struct backward_heading *earlier,
                   const struct backward_heading *now, double part)
{
    const int sign = now->at > earlier->at ? 1 : -1;
    double total[LOCAL_CARRY_MAX];
    struct backward_rest rest;

    for (size_t i = 0; i < r->way.carry->count; i++)
        total[i] = total_at(r, i);
    if (!backward_end_near(&r->way, earlier, now, total, part, &rest) ||
        !limit_exists(r->way.sys, now->ind, sign, now->dep))
        return false;
    r->rest = rest;
    r->out->end = now->ind == 0 ? BRANCH_LIMIT_Y : BRANCH_LIMIT_X;
    r->out->sign = sign;
    return true;
}

/* Whether the slope, slight as it is, fades no faster than a power and is
 * slighter where the curve is heading: it runs on for ever. */
static bool runs_on(const struct route *r, const struct backward_heading *c,
                    int sign)
{
    const double ahead = c->dep + copysign(TOL_NEARBY, sign * c->slope);
    const struct backward_heading there =
        backward_heading_at(&r->way, c->ind, local_point(c->ind, c->at, ahead));

    return fabs(c->slope) <= TOL_DRAWN * fmin(1.0, fabs(c->dep)) &&
           fabs(there.slope) <= fabs(c->slope) &&
           !limit_exists(r->way.sys, c->ind, sign, c->dep);
}

/* Of the last piece, in the coordinate that does not run: what is carried to
 * either end, and what the step misses between them; missed[]: before it. */
static void note_errors(struct route *r, size_t dep, const double missed[])
{
    struct orbit *o = &r->orbit;
    struct curve_piece *p = &o->curve.piece[o->curve.count - 1];
    const size_t ind = 1 - dep;
    const double unit = unit_of(r, dep), before = r->beside;
    const double slope = fabs(o->du[dep] / o->du[ind]);

    drift_cross(&r->drift, ind, o->curve.dim);
    r->beside = unit * drift_bar_at(&r->drift, ind, dep);
    p->error = fmax(before, r->beside) +
               unit * (o->error[dep] - missed[dep] +
                       slope * (o->error[ind] - missed[ind]));
}

/* One step; *done when the branch has ended with it: near its limit, at the
 * edge of the domain, where a limit must still be in sight, or without one. */
static enum status step(struct route *r, struct backward_heading *now,
                        bool *done)
{
    const struct backward_heading earlier = *now;
    const double missed[] = { r->orbit.error[0], r->orbit.error[1] };
    const enum status s = orbit_step(&r->orbit);

    if (s != STATUS_OK)
        return s;
    *now = backward_heading_at(&r->way, -1, place(r));
    r->ind = now->ind;
    note_errors(r, 1 - (size_t) now->ind, missed);
    const bool edge = r->orbit.end != ORBIT_RUNNING;
    const double part = edge ? TOL_SEEN : TOL_LITTLE * r->options->rtol;
    const int sign = now->at > earlier.at ? 1 : -1;
    *done = settle(r, &earlier, now, part) || edge ||
            (now->ind == earlier.ind && runs_on(r, now, sign));
    return STATUS_OK;
}

/* Follows the branch to its end. */
static enum status follow(struct route *r)
{
    enum status s = STATUS_OK;
    struct backward_heading now = backward_heading_at(&r->way, -1, r->start);

    for (bool done = false; s == STATUS_OK && !done;) {
        if (r->orbit.steps % TOL_MONITOR_STEPS == 0 &&
            monitor_tell(r->options->monitor, "second route", r->orbit.steps,
                         0))
            return STATUS_STOPPED;
        s = step(r, &now, &done);
        if (s == STATUS_OK && !done &&
            fmax(fabs(r->orbit.u[0]), fabs(r->orbit.u[1])) > TOL_BACKWARD_UNITS)
            s = change_units(r);
    }
    if (s == STATUS_TOO_MANY_STEPS || s == STATUS_NO_CONVERGENCE) {
        r->out->end = BRANCH_STEPS;
        s = STATUS_OK;
    }
    return s;
}

/* ---- what it came to ----------------------------------------------------- */

/* Of a number at the end: what was carried there, what is left, a rounding. */
static double bar(const struct route *r, size_t i, double rest, double value)
{
    return unit_of(r, i) * drift_bar_at(&r->drift, (size_t) r->ind, i) +
           TOL_BAR_FIRST_ORDER * fabs(rest) +
           TOL_ROUNDINGS_FEW * DBL_EPSILON * fabs(value);
}

static void report(const struct route *r)
{
    struct branch *b = r->out;
    double *dep = r->ind == 0 ? &b->limit.y : &b->limit.x;

    b->limit = place(r);
    *dep += r->rest.dep;
    *(r->ind == 0 ? &b->error.y : &b->error.x) =
        bar(r, 1 - (size_t) r->ind, r->rest.dep, *dep);
    for (size_t i = 0; i < r->way.carry->count; i++) {
        b->from_saddle[i] = r->way.converges[i];
        b->total[i] = total_at(r, i) + r->rest.total[i];
        b->total_error[i] =
            bar(r, component(r, i), r->rest.total[i], b->total[i]) + r->off[i] +
            INTEGRAL_NIL;
    }
}

/* The eigenvector on that side. */
static struct vec2 direction(const struct equilibrium *e, int side)
{
    const struct vec2 v = mat2_eigenvector(e->matrix, e->scaled[0]);
    const double up = v.x == 0.0 ? v.y : v.x;

    return vec2_scale(copysign(1.0, side * up) / vec2_length(v), v);
}

static bool good_options(const struct backward_options *o, int side)
{
    return o->rtol > 0.0 && o->rtol < 1.0 && abs(side) == 1 &&
           o->carry.count <= LOCAL_CARRY_MAX;
}

enum status backward_branch(const struct planar *sys,
                            const struct equilibrium *e, int side,
                            const struct backward_options *o,
                            struct branch *out)
{
    memset(out, 0, sizeof *out);
    if (!good_options(o, side) || !box_holds(sys->domain, sys->origin))
        return STATUS_BAD_ARGUMENT;
    if (!(e->scaled[0] < 0.0 && e->scaled[1] >= 0.0) ||
        equilibrium_is_beyond(e))
        return STATUS_NOT_HYPERBOLIC;
    *out = (struct branch){ .kind = MANIFOLD_STABLE,
                            .side = side,
                            .carry = o->carry,
                            .end = BRANCH_DOMAIN,
                            .curve = CURVE_EMPTY(2 + o->carry.count) };
    struct route r = {
        .way = backward_way_of(sys, &o->carry),
        .options = o,
        .tol = fmax(o->rtol, TOL_FINEST),
        .kappa = fmin(fmax(fabs(e->lambda[0]), DBL_MIN), DBL_MAX),
        .out = out,
    };
    enum status s = find_start(&r, direction(e, side)) ? add_start(&r)
                                                       : STATUS_NO_CONVERGENCE;

    if (s == STATUS_OK)
        s = begin(&r);
    if (s == STATUS_OK)
        s = follow(&r);
    if (s == STATUS_OK)
        s = add_orbit(&r);
    if (s == STATUS_OK)
        report(&r);
    orbit_free(&r.orbit);
    if (s != STATUS_OK)
        branch_free(out);
    return s;
}
