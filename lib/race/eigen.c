/*
 * Start: eigen_start.h.  Steps: Dormand-Prince 8(5,3) (flow.h) in arc length.
 * End: eigen_end.h; what is left is added and counts as error.  What is ours:
 * where far out X and Y are large and z = P W their small difference, (37)
 * fails in any variable, and a second leg goes on in z itself; lengths in units
 * of the leg's beginning, which may be 1e-200; weights that follow the curve.
 */
#include "eigen.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "eigen_end.h"
#include "eigen_leg.h"
#include "eigen_tolerance.h"
#include "limit.h"
#include "tolerance.h"

struct eigen_options eigen_defaults(double rtol)
{
    return (struct eigen_options){ .rtol = rtol, .max_steps = TOL_ORBIT_STEPS };
}

enum { LEGS = 2 };

/* One of two runs along a branch. */
struct route {
    const struct eigen_frame *frame;
    const struct eigen_options *options;
    struct eigen_start start;
    double start_error;         /* in the plane */
    struct eigen_leg leg[LEGS]; /* in W, in z; owned */
    size_t legs;
    enum branch_end end;
    int ind, sign;     /* the coordinate it ends along, and where to */
    struct vec2 limit; /* in the plane */
    double total[LOCAL_CARRY_MAX];
    struct eigen_rest rest; /* what the end added */
};

static const struct eigen_leg *last_leg(const struct route *r)
{
    return &r->leg[r->legs - 1];
}

/* Ends the route where what is left is below a part. */
static bool settle(struct route *r, const struct eigen_heading *earlier,
                   const struct eigen_heading *now, double part)
{
    const double *total = last_leg(r)->flow.u + 2;
    const int sign = now->at > earlier->at ? 1 : -1;
    struct eigen_rest rest;

    if (!eigen_end_near(r->frame, earlier, now, total, part, &rest) ||
        !limit_exists(r->frame->sys, now->ind, sign, now->dep))
        return false;
    r->rest = rest;
    r->end = now->ind == 0 ? BRANCH_LIMIT_Y : BRANCH_LIMIT_X;
    r->sign = sign;
    return true;
}

/* Whether the slope, slight as it is, fades no faster than a power and is
 * slighter where the curve is heading: it runs on for ever. */
static bool runs_on(const struct route *r, const struct eigen_heading *c,
                    int sign)
{
    const double ahead = c->dep + copysign(TOL_EIGEN_AHEAD, sign * c->slope);
    const struct eigen_heading there =
        eigen_heading_at(r->frame, c->ind, local_point(c->ind, c->at, ahead));

    return fabs(c->slope) <= TOL_EIGEN_SLIGHT * fmin(1.0, fabs(c->dep)) &&
           fabs(there.slope) <= fabs(c->slope) &&
           !limit_exists(r->frame->sys, c->ind, sign, c->dep);
}

/* Around an equilibrium a field is odd. */
static bool at_equilibrium(const struct eigen_leg *l)
{
    const struct planar *sys = l->frame->sys;
    const struct vec2 z = eigen_leg_end(l);
    const double d = TOL_EIGEN_ODD * vec2_length(z);
    struct planar_field a, b;

    sys->field(sys->ctx, (struct vec2){ z.x + d, z.y }, &a);
    sys->field(sys->ctx, (struct vec2){ z.x - d, z.y }, &b);
    return a.direction.x * b.direction.x + a.direction.y * b.direction.y < 0.0;
}

/* One step; *done when the branch has ended with it: near its limit, at the
 * edge of the domain, where a limit must still be in sight, or without one. */
static enum status step(struct route *r, struct eigen_heading *now, bool *done)
{
    struct eigen_leg *l = &r->leg[r->legs - 1];
    const struct eigen_heading earlier = *now;
    const enum status s = eigen_leg_step(l);

    if (s != STATUS_OK)
        return s;
    *now = eigen_heading_at(r->frame, -1, eigen_leg_end(l));
    r->ind = now->ind;
    const bool edge = l->flow.end == FLOW_EVENT;
    const double part =
        edge ? TOL_EIGEN_EDGE : TOL_EIGEN_REST * r->options->rtol;
    const int sign = now->at > earlier.at ? 1 : -1;
    *done = settle(r, &earlier, now, part) || edge ||
            (now->ind == earlier.ind && runs_on(r, now, sign));
    if (!*done && r->legs < LEGS && eigen_leg_cancellation(l) > TOL_EIGEN_LOST)
        return eigen_leg_turn(&r->leg[r->legs++], l);
    return STATUS_OK;
}

/* Follows the branch to its end. */
static enum status follow(struct route *r)
{
    enum status s = STATUS_OK;
    struct eigen_heading now =
        eigen_heading_at(r->frame, -1, eigen_leg_end(last_leg(r)));

    for (bool done = false; s == STATUS_OK && !done;) {
        const size_t steps = last_leg(r)->flow.steps;
        if (steps % TOL_MONITOR_STEPS == 0 &&
            monitor_tell(r->options->monitor, "second route", steps, 0))
            return STATUS_STOPPED;
        s = step(r, &now, &done);
    }
    if (s == STATUS_NO_CONVERGENCE && at_equilibrium(last_leg(r))) {
        r->end = BRANCH_EQUILIBRIUM;
        s = STATUS_OK;
    }
    if (s == STATUS_TOO_MANY_STEPS) {
        r->end = BRANCH_STEPS;
        s = STATUS_OK;
    }
    return s;
}

/* The whole branch from a start at `guess` or nearer.  The caller frees the
 * legs in any case. */
static enum status run(struct route *r, const struct eigen_frame *g,
                       const struct eigen_options *o, double step_rtol,
                       double guess)
{
    *r = (struct route){ .frame = g, .options = o, .end = BRANCH_DOMAIN };
    enum status s = eigen_start_find(g, step_rtol, guess, &r->start);
    if (s == STATUS_OK)
        s = eigen_leg_begin(&r->leg[r->legs++], g, &r->start, step_rtol,
                            o->max_steps);
    if (s != STATUS_OK)
        return s;
    r->start_error = eigen_drift_of_point(&r->leg[0].drift);
    s = follow(r);
    if (s != STATUS_OK)
        return s;
    r->limit = eigen_leg_end(last_leg(r));
    *(r->ind == 0 ? &r->limit.y : &r->limit.x) += r->rest.dep;
    for (size_t i = 0; i < g->carry->count; i++)
        r->total[i] = last_leg(r)->flow.u[i + 2] + r->rest.total[i];
    return STATUS_OK;
}

/* Appends a piece of degree n, its first two components mapped by M. */
static enum status append(struct curve *c, size_t n, const double coef[],
                          struct mat2 M, double error)
{
    double *target;
    const enum status s = curve_push(c, n, &target);

    if (s != STATUS_OK)
        return s;
    memcpy(target, coef, c->dim * (n + 1) * sizeof *coef);
    for (size_t j = 0; j <= n; j++) {
        const struct vec2 z =
            eigen_point(M, (struct vec2){ coef[j], coef[n + 1 + j] });
        target[j] = z.x;
        target[n + 1 + j] = z.y;
    }
    c->piece[c->count - 1].error = error;
    return STATUS_OK;
}

/* The curve of a route from the saddle on. */
static enum status copy_curve(const struct route *r, struct curve *c)
{
    const struct eigen_start *t = &r->start;
    double coef[CURVE_DIM_MAX][EIGEN_START_DEGREE + 1] = { { 0.0, t->reach } };

    memcpy(coef[1], t->Y, sizeof t->Y);
    memcpy(coef[2], t->integral, sizeof t->integral);
    enum status s =
        append(c, EIGEN_START_DEGREE, coef[0], r->frame->basis, r->start_error);
    for (size_t k = 0; k < r->legs; k++) {
        const struct curve *from = &r->leg[k].flow.curve;
        for (size_t i = 0; i < from->count && s == STATUS_OK; i++)
            s = append(c, from->piece[i].degree, curve_component(from, i, 0),
                       r->leg[k].map, from->piece[i].error);
    }
    return s;
}

/* Error of the finer run: its difference from the coarser one; what its own
 * errors come to, which differences may miss by chance; the end; a rounding. */
static double bar(double difference, double drift, double rest, double value)
{
    return fabs(difference) + drift + TOL_EIGEN_RESTS * fabs(rest) +
           TOL_ROUNDINGS_FEW * DBL_EPSILON * fabs(value);
}

static bool ends_alike(const struct route *a, const struct route *b)
{
    return a->end == b->end && a->ind == b->ind && a->sign == b->sign;
}

/* Of the coordinate that is not infinite, or not clamped to the edge. */
static void report_limit(const struct route *fine, const struct route *coarse,
                         struct branch *b)
{
    const bool over_x = fine->ind == 0;
    const struct vec2 off = vec2_sub(fine->limit, coarse->limit);
    const double drift =
        eigen_drift_of_limit(&last_leg(fine)->drift, fine->ind);
    double *error = over_x ? &b->error.y : &b->error.x;

    *error = ends_alike(fine, coarse)
                 ? bar(over_x ? off.y : off.x, drift, fine->rest.dep,
                       over_x ? fine->limit.y : fine->limit.x)
                 : HUGE_VAL;
}

static void report_totals(const struct route *fine, const struct route *coarse,
                          struct branch *b)
{
    for (size_t i = 0; i < fine->frame->carry->count; i++) {
        const double total = fine->total[i];
        b->from_saddle[i] = fine->frame->converges[i];
        const double off = b->from_saddle[i] ? total - coarse->total[i] : 0.0;
        b->total[i] = total;
        b->total_error[i] = ends_alike(fine, coarse)
                                ? bar(off, last_leg(fine)->drift.total[i],
                                      fine->rest.total[i], total) +
                                      TOL_INTEGRAL_NIL
                                : HUGE_VAL;
    }
}

static void count_work(const struct route *r, struct branch *b)
{
    for (size_t k = 0; k < r->legs; k++) {
        b->steps += r->leg[k].flow.steps;
        b->rejected += r->leg[k].flow.rejected;
        b->evaluations += r->leg[k].flow.calls;
    }
}

static void report(const struct route *fine, const struct route *coarse,
                   struct branch *b)
{
    b->end = fine->end;
    b->sign = fine->sign;
    b->limit = fine->limit;
    report_limit(fine, coarse, b);
    report_totals(fine, coarse, b);
    count_work(fine, b);
    count_work(coarse, b);
}

static void free_legs(struct route *r)
{
    for (size_t k = 0; k < r->legs; k++)
        eigen_leg_free(&r->leg[k]);
}

static bool good_options(const struct eigen_options *o, int side)
{
    return o->rtol > 0.0 && o->rtol < 1.0 && abs(side) == 1 &&
           o->carry.count <= LOCAL_CARRY_MAX;
}

/* Both runs, and a copy of the finer curve. */
static enum status make_branch(const struct eigen_frame *g, int side,
                               const struct eigen_options *o,
                               struct branch *out)
{
    const double tol = fmax(TOL_EIGEN_STEP * o->rtol, TOL_FINEST);
    struct route fine = { 0 }, coarse = { 0 };

    enum status s =
        run(&coarse, g, o, TOL_EIGEN_COARSE * tol, side * TOL_EIGEN_START);
    if (s == STATUS_OK)
        s = run(&fine, g, o, tol, 0.5 * coarse.start.reach);
    if (s != STATUS_OK)
        goto out;
    report(&fine, &coarse, out);
    s = copy_curve(&fine, &out->curve);
out:
    free_legs(&fine);
    free_legs(&coarse);
    return s;
}

enum status eigen_branch(const struct planar *sys, const struct equilibrium *e,
                         int side, const struct eigen_options *o,
                         struct branch *out)
{
    memset(out, 0, sizeof *out);
    if (!good_options(o, side) || !box_holds(sys->domain, sys->origin))
        return STATUS_BAD_ARGUMENT;
    if (!(e->scaled[0] < 0.0 && e->scaled[1] >= 0.0) ||
        equilibrium_is_beyond(e))
        return STATUS_NOT_HYPERBOLIC;
    const struct eigen_frame g = eigen_frame_at(sys, e, &o->carry);
    *out = (struct branch){ .kind = MANIFOLD_STABLE,
                            .side = side,
                            .carry = o->carry,
                            .curve = CURVE_EMPTY(2 + o->carry.count) };
    const enum status s = make_branch(&g, side, o, out);
    if (s != STATUS_OK)
        branch_free(out);
    return s;
}
