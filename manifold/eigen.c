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

#include "eigen_drift.h"
#include "eigen_end.h"
#include "eigen_start.h"
#include "flow.h"
#include "tolerance.h"

struct eigen_options eigen_defaults(double rtol)
{
    return (struct eigen_options){ .rtol = rtol, .max_steps = TOL_EIGEN_STEPS };
}

/* A stretch in one set of coordinates, z = map u. */
struct leg {
    const struct eigen_frame *frame;
    struct mat2 map;
    struct ode ode; /* u, integrals */
    struct event edge;
    struct flow flow; /* owned */
};

enum { LEGS = 2 };

/* One of two runs along a branch. */
struct route {
    const struct eigen_frame *frame;
    const struct eigen_options *options;
    double step_rtol;
    struct eigen_start start;
    struct leg leg[LEGS]; /* in W, in z */
    size_t legs;
    struct eigen_drift drift;
    enum branch_end end;
    int ind, sign;     /* the coordinate it ends along, and where to */
    struct vec2 limit; /* in the plane */
    double total[LOCAL_CARRY_MAX];
    struct eigen_rest rest; /* what the end added */
};

/* The point of the plane. */
static struct vec2 point_of(const struct leg *l, const double u[])
{
    return eigen_point(l->map, (struct vec2){ u[0], u[1] });
}

/* Unit speed outwards, against the field. */
static void unit_speed(const void *ctx, double s, const double u[], double du[])
{
    const struct leg *l = ctx;
    const struct eigen_frame *g = l->frame;
    const struct vec2 z = point_of(l, u);
    struct planar_field f;

    (void) s;
    g->sys->field(g->sys->ctx, z, &f);
    const struct vec2 v = eigen_coordinates(l->map, f.direction);
    const double pace = -1.0 / vec2_length(v);
    du[0] = pace * v.x;
    du[1] = pace * v.y;
    for (size_t i = 0; i < g->carry->count; i++)
        du[i + 2] = pace * eigen_rate(g, i, z, f.log_scale);
}

/* How far inside the domain; negative outside. */
static double depth(const void *ctx, double s, const double u[])
{
    const struct leg *l = ctx;
    const struct planar *sys = l->frame->sys;
    const struct box d = sys->domain;
    const struct vec2 z = vec2_add(sys->origin, point_of(l, u));

    (void) s;
    return fmin(fmin(z.x - d.lo.x, d.hi.x - z.x),
                fmin(z.y - d.lo.y, d.hi.y - z.y));
}

/* A further leg from u on; atol: of u[0] and u[1]. */
static enum status begin_leg(struct route *r, struct mat2 map, const double u[],
                             const double atol[2])
{
    struct leg *l = &r->leg[r->legs++];
    const size_t n = r->frame->carry->count;
    struct flow_options o = { .rtol = r->step_rtol,
                              .atol = { atol[0], atol[1] },
                              .first_step = 0.25,
                              .max_steps = r->options->max_steps,
                              .event = &l->edge,
                              .events = 1 };
    double du[CURVE_DIM_MAX];

    l->frame = r->frame;
    l->map = map;
    unit_speed(l, 0.0, u, du);
    for (size_t i = 0; i < n; i++)
        o.atol[i + 2] = r->step_rtol * fabs(du[i + 2]) + DBL_MIN;
    l->ode = (struct ode){ 2 + n, unit_speed, l };
    l->edge = (struct event){ depth, l, -1, true };
    return flow_init(&l->flow, &l->ode, 0.0, u, &o);
}

static struct mat2 scaled(double k, struct mat2 M)
{
    return (struct mat2){ k * M.xx, k * M.xy, k * M.yx, k * M.yy };
}

/* From the start's end, in W. */
static enum status begin(struct route *r)
{
    const double none[2] = { DBL_MIN, DBL_MIN };
    const double unit = fabs(r->start.reach);
    double u[CURVE_DIM_MAX] = { copysign(1.0, r->start.reach) };

    u[1] = eigen_start_point(&r->start, 1.0).y / unit;
    for (size_t i = 0; i < r->frame->carry->count; i++) {
        const double *c = r->start.integral[i];
        u[i + 2] = c[1] + c[2] + c[3];
    }
    const struct mat2 map = scaled(unit, r->frame->basis);
    eigen_drift_begin(&r->drift, r->frame, map, u);
    return begin_leg(r, map, u, none);
}

/* The sizes of what z = map u adds up. */
static struct vec2 parts_of(const struct leg *l, const double u[])
{
    return (struct vec2){ fabs(l->map.xx * u[0]) + fabs(l->map.xy * u[1]),
                          fabs(l->map.yx * u[0]) + fabs(l->map.yy * u[1]) };
}

/* How many times smaller z is than what it is the difference of; at least 1. */
static double cancellation(const struct leg *l)
{
    const struct vec2 z = point_of(l, l->flow.u);
    const struct vec2 parts = parts_of(l, l->flow.u);
    const double x = parts.x / fabs(z.x), y = parts.y / fabs(z.y);

    return fmax(fmax(x, y), 1.0);
}

/* On in z, weighed by its size here. */
static enum status change_over(struct route *r)
{
    const struct flow *f = &r->leg[0].flow;
    const struct vec2 z = point_of(&r->leg[0], f->u);
    const double unit = vec2_length(z);
    const struct mat2 identity = { 1.0, 0.0, 0.0, 1.0 };
    const double atol[2] = { r->step_rtol * fabs(z.x) / unit + DBL_MIN,
                             r->step_rtol * fabs(z.y) / unit + DBL_MIN };
    double u[CURVE_DIM_MAX];

    memcpy(u, f->u, sizeof u);
    u[0] = z.x / unit;
    u[1] = z.y / unit;
    eigen_drift_turn(&r->drift, r->frame, scaled(unit, identity), u);
    return begin_leg(r, scaled(unit, identity), u, atol);
}

/* Error weights that follow the curve, and the longest step. */
static void set_weights(const struct route *r, struct leg *l)
{
    struct flow *f = &l->flow;
    const double pace = vec2_length(point_of(l, f->work.k[0]));

    f->options.rtol = r->step_rtol / fmin(cancellation(l), TOL_EIGEN_LOST);
    if (r->legs == 1)
        f->options.atol[1] =
            f->options.rtol * r->frame->thin * fabs(f->u[0]) + DBL_MIN;
    for (size_t i = 0; i < r->frame->carry->count; i++)
        f->options.atol[i + 2] =
            fmax(f->options.atol[i + 2],
                 TOL_EIGEN_NOISE * r->drift.noise[i] * (1.0 + f->s));
    f->h = fmin(f->h, TOL_EIGEN_LONGEST / pace);
}

/* Ends the route where what is left is below a part. */
static bool settle(struct route *r, const struct eigen_course *earlier,
                   const struct eigen_course *now, double part)
{
    const double *total = r->leg[r->legs - 1].flow.u + 2;
    struct eigen_rest rest;

    if (!eigen_end_near(r->frame, earlier, now, total, part, &rest))
        return false;
    r->rest = rest;
    r->end = now->ind == 0 ? BRANCH_LIMIT_Y : BRANCH_LIMIT_X;
    r->sign = now->at > earlier->at ? 1 : -1;
    return true;
}

/* Around an equilibrium a field is odd. */
static bool at_equilibrium(const struct leg *l)
{
    const struct planar *sys = l->frame->sys;
    const struct vec2 z = point_of(l, l->flow.u);
    const double d = TOL_EIGEN_ODD * vec2_length(z);
    struct planar_field a, b;

    sys->field(sys->ctx, (struct vec2){ z.x + d, z.y }, &a);
    sys->field(sys->ctx, (struct vec2){ z.x - d, z.y }, &b);
    return a.direction.x * b.direction.x + a.direction.y * b.direction.y < 0.0;
}

/* The last step's part in the drift; `before`: sums of its estimates. */
static void add_drift(struct route *r, const struct leg *l, double h,
                      const double before[])
{
    double error[CURVE_DIM_MAX];

    for (size_t i = 0; i < l->ode.dim; i++)
        error[i] = TOL_EIGEN_ESTIMATES * (l->flow.error[i] - before[i]);
    eigen_drift_step(&r->drift, r->frame, h, l->flow.u, error);
}

/* One step; *done when the branch has ended with it: near its limit, or at the
 * edge of the domain, where a limit must still be in sight. */
static enum status step(struct route *r, struct eigen_course *now, bool *done)
{
    struct leg *l = &r->leg[r->legs - 1];
    const struct eigen_course earlier = *now;
    const double s = l->flow.s;
    double before[CURVE_DIM_MAX];

    memcpy(before, l->flow.error, sizeof before);
    set_weights(r, l);
    const enum status status = flow_step(&l->flow, HUGE_VAL);
    if (status != STATUS_OK)
        return status;
    add_drift(r, l, l->flow.s - s, before);
    *now = eigen_course_at(r->frame, -1, point_of(l, l->flow.u));
    r->ind = now->ind;
    const bool edge = l->flow.end == FLOW_EVENT;
    const bool settled =
        settle(r, &earlier, now,
               edge ? TOL_EIGEN_EDGE : TOL_EIGEN_REST * r->options->rtol);
    *done = edge || settled;
    return STATUS_OK;
}

/* Follows the branch to its end. */
static enum status follow(struct route *r)
{
    enum status s = STATUS_OK;
    struct leg *l = &r->leg[0];
    struct eigen_course now =
        eigen_course_at(r->frame, -1, point_of(l, l->flow.u));

    for (bool done = false; s == STATUS_OK && !done;) {
        l = &r->leg[r->legs - 1];
        if (l->flow.steps % TOL_MONITOR_STEPS == 0 &&
            monitor_tell(r->options->monitor, "second route", l->flow.steps, 0))
            return STATUS_STOPPED;
        s = step(r, &now, &done);
        if (s == STATUS_OK && !done && r->legs < LEGS &&
            cancellation(l) > TOL_EIGEN_LOST)
            s = change_over(r);
    }
    if (s == STATUS_NO_CONVERGENCE && at_equilibrium(l)) {
        r->end = BRANCH_EQUILIBRIUM;
        s = STATUS_OK;
    }
    if (s == STATUS_TOO_MANY_STEPS) {
        r->end = BRANCH_STEPS;
        s = STATUS_OK;
    }
    return s;
}

/* The whole branch from a start at `guess` or nearer.  The caller frees
 * the legs' flows in any case. */
static enum status run(struct route *r, const struct eigen_frame *g,
                       const struct eigen_options *o, double step_rtol,
                       double guess)
{
    *r = (struct route){
        .frame = g, .options = o, .step_rtol = step_rtol, .end = BRANCH_DOMAIN
    };
    enum status s = eigen_start_find(g, step_rtol, guess, &r->start);
    if (s == STATUS_OK)
        s = begin(r);
    if (s == STATUS_OK)
        s = follow(r);
    if (s != STATUS_OK)
        return s;
    const struct leg *last = &r->leg[r->legs - 1];
    r->limit = point_of(last, last->flow.u);
    *(r->ind == 0 ? &r->limit.y : &r->limit.x) += r->rest.dep;
    for (size_t i = 0; i < g->carry->count; i++)
        r->total[i] = last->flow.u[i + 2] + r->rest.total[i];
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

static struct mat2 product(struct mat2 A, struct mat2 B)
{
    return (struct mat2){ A.xx * B.xx + A.xy * B.yx, A.xx * B.xy + A.xy * B.yy,
                          A.yx * B.xx + A.yy * B.yx,
                          A.yx * B.xy + A.yy * B.yy };
}

static struct mat2 inverse(struct mat2 P)
{
    const struct vec2 u = eigen_coordinates(P, (struct vec2){ 1.0, 0.0 });
    const struct vec2 v = eigen_coordinates(P, (struct vec2){ 0.0, 1.0 });
    return (struct mat2){ u.x, v.x, u.y, v.y };
}

/* The curve of a route from the saddle on, as offsets z, or else as W: W is a
 * leg's own coordinate on the first, P^-1 z on the second. */
static enum status copy_curve(const struct route *r, bool plane, double error,
                              struct curve *c)
{
    const struct eigen_start *t = &r->start;
    const struct mat2 identity = { 1.0, 0.0, 0.0, 1.0 };
    const struct mat2 P = r->frame->basis;
    const struct mat2 first = plane ? P : identity, back = inverse(P);
    double coef[CURVE_DIM_MAX][EIGEN_START_DEGREE + 1] = { { 0.0, t->reach } };

    memcpy(coef[1], t->Y, sizeof t->Y);
    memcpy(coef[2], t->integral, sizeof t->integral);
    enum status s = append(c, EIGEN_START_DEGREE, coef[0], first, error);
    for (size_t k = 0; k < r->legs; k++) {
        const struct curve *from = &r->leg[k].flow.curve;
        const struct mat2 map = plane    ? r->leg[k].map
                                : k == 0 ? scaled(fabs(t->reach), identity)
                                         : product(back, r->leg[k].map);
        for (size_t i = 0; i < from->count && s == STATUS_OK; i++)
            s = append(c, from->piece[i].degree, curve_component(from, i, 0),
                       map, error);
    }
    return s;
}

/* Error of the finer run: its difference from the coarser one; what its own
 * errors come to, which differences may miss by chance; the end; a rounding. */
static double bar(double difference, double drift, double rest, double value)
{
    return fabs(difference) + drift + TOL_EIGEN_RESTS * fabs(rest) +
           TOL_EIGEN_ROUNDING * DBL_EPSILON * fabs(value);
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
    const double drift = eigen_drift_of_limit(&fine->drift, fine->ind);
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
        b->total_error[i] =
            ends_alike(fine, coarse)
                ? bar(off, fine->drift.total[i], fine->rest.total[i], total)
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
        flow_free(&r->leg[k].flow);
}

static bool good_options(const struct eigen_options *o, int side)
{
    return o->rtol > 0.0 && o->rtol < 1.0 && abs(side) == 1 &&
           o->carry.count <= LOCAL_CARRY_MAX;
}

/* Both runs, and both copies of the finer curve. */
static enum status make_branch(const struct eigen_frame *g, int side,
                               const struct eigen_options *o,
                               struct eigen_branch *out)
{
    const double tol = fmax(TOL_EIGEN_STEP * o->rtol, TOL_EIGEN_FINEST);
    struct route fine = { 0 }, coarse = { 0 };

    enum status s =
        run(&coarse, g, o, TOL_EIGEN_COARSE * tol, side * TOL_EIGEN_START);
    if (s == STATUS_OK)
        s = run(&fine, g, o, tol, 0.5 * coarse.start.reach);
    if (s != STATUS_OK)
        goto out;
    report(&fine, &coarse, &out->branch);
    const double error = fmax(out->branch.error.x, out->branch.error.y);
    s = copy_curve(&fine, false, error, &out->curve);
    if (s == STATUS_OK)
        s = copy_curve(&fine, true, error, &out->branch.curve);
out:
    free_legs(&fine);
    free_legs(&coarse);
    return s;
}

enum status eigen_branch(const struct planar *sys, const struct equilibrium *e,
                         int side, const struct eigen_options *o,
                         struct eigen_branch *out)
{
    memset(out, 0, sizeof *out);
    if (!good_options(o, side) || !box_holds(sys->domain, sys->origin))
        return STATUS_BAD_ARGUMENT;
    if (!(e->scaled[0] < 0.0 && e->scaled[1] >= 0.0))
        return STATUS_NOT_HYPERBOLIC;
    const struct eigen_frame g = eigen_frame_at(sys, e, &o->carry);
    out->basis = g.basis;
    out->curve = CURVE_EMPTY(2 + o->carry.count);
    out->branch = (struct branch){ .kind = MANIFOLD_STABLE,
                                   .side = side,
                                   .carry = o->carry,
                                   .curve = out->curve };
    const enum status s = make_branch(&g, side, o, out);
    if (s != STATUS_OK)
        eigen_branch_free(out);
    return s;
}

void eigen_branch_free(struct eigen_branch *b)
{
    curve_free(&b->curve);
    branch_free(&b->branch);
}
