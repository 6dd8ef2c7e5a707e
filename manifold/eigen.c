/*
 * Start: S = c2 X^2 + c3 X^3 by collocation of S' = Ydot/Xdot at two points,
 * the distance halved until a third point agrees.  Steps: Dormand-Prince 8(5,3)
 * (flow.h) in arc length.  End: followed until what an exponential through the
 * last two steps leaves over is negligible; that remainder is added and counts
 * as error.  What is ours: tolerances that follow the curve, since Y starts at
 * zero and x = P W may stay a thousand times smaller than X and Y.
 */
#include "eigen.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "flow.h"
#include "tolerance.h"

enum { FIT_SWEEPS = 8, START_ATTEMPTS = 100, START_DEGREE = 3 };

struct eigen_options eigen_defaults(double rtol)
{
    return (struct eigen_options){ .rtol = rtol,
                                   .max_steps = TOL_BRANCH_STEPS };
}

static struct vec2 column(const struct equilibrium *e, int which)
{
    const struct vec2 v = mat2_eigenvector(e->matrix, e->scaled[which]);
    return vec2_scale(1.0 / fmax(fabs(v.x), fabs(v.y)), v);
}

struct mat2 eigen_basis(const struct equilibrium *e)
{
    const struct vec2 u = column(e, 0), v = column(e, 1);
    return (struct mat2){ u.x, v.x, u.y, v.y };
}

struct vec2 eigen_point(struct mat2 P, struct vec2 W)
{
    return (struct vec2){ P.xx * W.x + P.xy * W.y, P.yx * W.x + P.yy * W.y };
}

struct vec2 eigen_coordinates(struct mat2 P, struct vec2 z)
{
    const double det = mat2_det(P);
    return (struct vec2){ (P.yy * z.x - P.xy * z.y) / det,
                          (P.xx * z.y - P.yx * z.x) / det };
}

/* What does not change along a branch. */
struct frame {
    const struct planar *sys;
    const struct carry *carry;
    struct mat2 basis;
    double ratio; /* lambda_+ / lambda_- */
    double thin;  /* Y matters where it is this part of X */
    int side;
    bool converges[LOCAL_CARRY_MAX];
};

/* The velocity of (X, Y) over exp(*log_scale). */
static struct vec2 velocity(const struct frame *g, struct vec2 W,
                            double *log_scale)
{
    struct planar_field f;

    g->sys->field(g->sys->ctx, eigen_point(g->basis, W), &f);
    *log_scale = f.log_scale;
    return eigen_coordinates(g->basis, f.direction);
}

/* The rate of carried quantity i over exp(log_scale). */
static double rate(const struct frame *g, size_t i, struct vec2 W,
                   double log_scale)
{
    const int which = g->carry->which[i];
    struct vec2 gradient;
    double r = 1.0;

    if (which != CARRY_TIME)
        g->sys->rate_gradient(g->sys->ctx, (size_t) which,
                              eigen_point(g->basis, W), &r, &gradient);
    return r * exp(-log_scale);
}

/* x moves by this part of X at first, and by Y later. */
static double thinness(struct mat2 P)
{
    return P.xx == 0.0 ? 1.0 : fmin(fabs(P.xx / P.xy), 1.0);
}

static void set_frame(struct frame *g, const struct planar *sys,
                      const struct equilibrium *e, int side,
                      const struct carry *carry)
{
    double none;

    *g = (struct frame){ .sys = sys,
                         .carry = carry,
                         .basis = eigen_basis(e),
                         .ratio = e->scaled[1] / e->scaled[0],
                         .side = side };
    g->thin = thinness(g->basis);
    velocity(g, (struct vec2){ 0.0, 0.0 }, &none);
    for (size_t i = 0; i < carry->count; i++)
        g->converges[i] = rate(g, i, (struct vec2){ 0.0, 0.0 }, 0.0) == 0.0;
}

/* The curve from the saddle to its first step: S = c2 X^2 + c3 X^3, and the
 * integrals as polynomials in X/reach. */
struct start {
    double reach; /* X at its end, signed */
    double c2, c3;
    double integral[LOCAL_CARRY_MAX][START_DEGREE + 1];
};

static struct vec2 start_point(const struct start *t, double X)
{
    return (struct vec2){ X, X * X * (t->c2 + X * t->c3) };
}

/* S' - Ydot/Xdot at X */
static double defect(const struct frame *g, const struct start *t, double X)
{
    double none;
    const struct vec2 v = velocity(g, start_point(t, X), &none);
    return X * (2.0 * t->c2 + 3.0 * X * t->c3) - v.y / v.x;
}

/* A change of c_k changes the defect by (k - ratio) X^(k-1), to first order:
 * sweeps of Newton's method with the saddle's own Jacobian. */
static void fit(const struct frame *g, struct start *t)
{
    const double X = t->reach;

    t->c2 = t->c3 = 0.0;
    for (int i = 0; i < FIT_SWEEPS; i++) {
        const double near = 2.0 * defect(g, t, 0.5 * X) / X;
        const double far = defect(g, t, X) / X;
        t->c2 -= (2.0 * near - far) / (2.0 - g->ratio);
        t->c3 -= 2.0 * (far - near) / X / (3.0 - g->ratio);
    }
}

/* d integral i/d(X/reach) at a part of the way, over time from the saddle. */
static double integrand(const struct frame *g, const struct start *t, size_t i,
                        double part)
{
    double log_scale;
    const struct vec2 W = start_point(t, part * t->reach);
    const struct vec2 v = velocity(g, W, &log_scale);

    return t->reach * rate(g, i, W, log_scale) / v.x;
}

/* The integrands, smooth but 0/0 at the saddle, are interpolated at thirds of
 * the way.  False if a fourth point does not agree. */
static bool fit_integrals(const struct frame *g, double tol, struct start *t)
{
    memset(t->integral, 0, sizeof t->integral);
    for (size_t i = 0; i < g->carry->count; i++) {
        if (!g->converges[i])
            continue;
        const double p = integrand(g, t, i, 1.0 / 3.0);
        const double q = integrand(g, t, i, 2.0 / 3.0);
        const double r = integrand(g, t, i, 1.0);
        const double bend = r - 2.0 * q + p, rise = q - p - 1.5 * bend;
        const double first = p - rise - 0.5 * bend;
        const double test = first + 2.5 * rise + 3.125 * bend;
        if (!(fabs(test - integrand(g, t, i, 5.0 / 6.0)) <= tol * fabs(test)))
            return false;
        t->integral[i][1] = first;
        t->integral[i][2] = 1.5 * rise;
        t->integral[i][3] = 1.5 * bend;
    }
    return true;
}

/* From a first guess of the reach, shortened until the series agrees with the
 * field between the points of its collocation. */
static enum status find_start(const struct frame *g, double tol, double guess,
                              struct start *t)
{
    t->reach = g->side * guess;
    for (int i = 0; i < START_ATTEMPTS; i++) {
        fit(g, t);
        const struct vec2 W = start_point(t, t->reach);
        const double off = fabs(t->reach * defect(g, t, 0.75 * t->reach));
        const double allowed = tol * (fabs(W.y) + g->thin * fabs(W.x));
        if (off <= allowed && fit_integrals(g, tol, t))
            return STATUS_OK;
        const double factor = 0.9 * cbrt(allowed / off);
        t->reach *= factor > 0.01 ? fmin(factor, 0.5) : 0.01;
    }
    return STATUS_NO_CONVERGENCE;
}

/* Unit speed outwards, against the field. */
static void unit_speed(const void *ctx, double s, const double u[], double du[])
{
    const struct frame *g = ctx;
    const struct vec2 W = { u[0], u[1] };
    double log_scale;
    const struct vec2 v = velocity(g, W, &log_scale);
    const double pace = -1.0 / vec2_length(v);

    (void) s;
    du[0] = pace * v.x;
    du[1] = pace * v.y;
    for (size_t i = 0; i < g->carry->count; i++)
        du[i + 2] = pace * rate(g, i, W, log_scale);
}

/* How far inside the domain; negative outside. */
static double depth(const void *ctx, double s, const double u[])
{
    const struct frame *g = ctx;
    const struct box d = g->sys->domain;
    const struct vec2 z = vec2_add(
        g->sys->origin, eigen_point(g->basis, (struct vec2){ u[0], u[1] }));

    (void) s;
    return fmin(fmin(z.x - d.lo.x, d.hi.x - z.x),
                fmin(z.y - d.lo.y, d.hi.y - z.y));
}

/* How the curve runs at a point: the coordinate that moves faster, and how
 * fast the other one and the integrals follow. */
struct course {
    int ind;
    double at;    /* coordinate ind */
    double slope; /* d dep/d ind */
    double swift[LOCAL_CARRY_MAX];
};

static void course_at(const struct frame *g, const double u[], struct course *c)
{
    const struct vec2 W = { u[0], u[1] };
    const struct vec2 z = eigen_point(g->basis, W);
    struct planar_field f;

    g->sys->field(g->sys->ctx, z, &f);
    const struct vec2 d = f.direction;
    c->ind = fabs(d.y) <= fabs(d.x) ? 0 : 1;
    c->at = c->ind == 0 ? z.x : z.y;
    c->slope = c->ind == 0 ? d.y / d.x : d.x / d.y;
    for (size_t i = 0; i < g->carry->count; i++)
        c->swift[i] = rate(g, i, W, f.log_scale) / (c->ind == 0 ? d.x : d.y);
}

/* One of two runs along a branch. */
struct route {
    const struct frame *frame;
    struct start start;
    struct ode ode;
    struct event edge;
    struct flow flow; /* owned */
    enum branch_end end;
    int ind, sign;           /* the coordinate it ends along, and where to */
    struct vec2 limit, rest; /* rest: what the end added */
    double total[LOCAL_CARRY_MAX], total_rest[LOCAL_CARRY_MAX];
};

/* What is left of a quantity whose rate went from `before` to `now` over the
 * stretch `gap`, if it goes on so; infinite where it does not decay. */
static double remainder_of(double before, double now, double gap)
{
    const double decay = log(before / now) / fabs(gap);

    if (now == 0.0)
        return 0.0;
    return decay > TOL_EIGEN_DECAY ? copysign(now, now * gap) / decay
                                   : HUGE_VAL;
}

/* Ends the route where the remainders are negligible. */
static bool settle(struct route *r, const struct course *before,
                   const struct course *now, double rtol)
{
    const struct frame *g = r->frame;
    const double gap = now->at - before->at, tol = TOL_EIGEN_REST * rtol;
    const double *u = r->flow.u;
    const struct vec2 z = eigen_point(g->basis, (struct vec2){ u[0], u[1] });
    const double left = remainder_of(before->slope, now->slope, gap);

    if (now->ind != before->ind ||
        !(fabs(left) <= tol * fabs(now->ind == 0 ? z.y : z.x)))
        return false;
    for (size_t i = 0; i < g->carry->count; i++) {
        const double part = remainder_of(before->swift[i], now->swift[i], gap);
        if (g->converges[i] && !(fabs(part) <= tol * fabs(u[i + 2])))
            return false;
        r->total_rest[i] = g->converges[i] ? part : 0.0;
    }
    r->end = now->ind == 0 ? BRANCH_LIMIT_Y : BRANCH_LIMIT_X;
    r->sign = gap > 0.0 ? 1 : -1;
    *(now->ind == 0 ? &r->rest.y : &r->rest.x) = left;
    return true;
}

/* Around an equilibrium a field is odd. */
static bool at_equilibrium(const struct route *r)
{
    const double *u = r->flow.u, d = TOL_EIGEN_ODD * hypot(u[0], u[1]);
    double none;
    const struct vec2 a =
        velocity(r->frame, (struct vec2){ u[0] + d, u[1] }, &none);
    const struct vec2 b =
        velocity(r->frame, (struct vec2){ u[0] - d, u[1] }, &none);

    return a.x * b.x + a.y * b.y < 0.0;
}

/* Error weights that follow the curve. */
static void set_weights(struct route *r)
{
    struct flow *f = &r->flow;

    f->options.atol[1] =
        f->options.rtol * r->frame->thin * fabs(f->u[0]) + DBL_MIN;
    f->h = fmin(f->h, TOL_EIGEN_LONGEST);
}

static enum status begin(struct route *r, double rtol, size_t max_steps)
{
    const struct frame *g = r->frame;
    const struct start *t = &r->start;
    const struct vec2 W = start_point(t, t->reach);
    struct flow_options o = { .rtol = rtol,
                              .atol = { DBL_MIN, DBL_MIN },
                              .first_step = 0.25 * fabs(t->reach),
                              .max_steps = max_steps,
                              .event = &r->edge,
                              .events = 1 };
    double u[CURVE_DIM_MAX] = { W.x, W.y }, du[CURVE_DIM_MAX];

    unit_speed(g, 0.0, u, du);
    for (size_t i = 0; i < g->carry->count; i++) {
        const double *c = t->integral[i];
        u[i + 2] = c[1] + c[2] + c[3];
        o.atol[i + 2] = rtol * fabs(du[i + 2] * W.x) + DBL_MIN;
    }
    r->ode = (struct ode){ 2 + g->carry->count, unit_speed, g };
    r->edge = (struct event){ depth, g, -1, true };
    return flow_init(&r->flow, &r->ode, 0.0, u, &o);
}

/* Follows the branch to its end. */
static enum status follow(struct route *r, double rtol,
                          const struct monitor *monitor)
{
    struct course before, now;
    struct flow *f = &r->flow;
    enum status s = STATUS_OK;

    course_at(r->frame, f->u, &now);
    for (bool done = false; s == STATUS_OK && !done;) {
        before = now;
        set_weights(r);
        if (f->steps % TOL_MONITOR_STEPS == 0 &&
            monitor_tell(monitor, "manifold", f->steps, 0))
            return STATUS_STOPPED;
        s = flow_step(f, HUGE_VAL);
        course_at(r->frame, f->u, &now);
        r->ind = now.ind;
        done = f->end == FLOW_EVENT ||
               (s == STATUS_OK && settle(r, &before, &now, rtol));
    }
    if (s == STATUS_NO_CONVERGENCE && at_equilibrium(r)) {
        r->end = BRANCH_EQUILIBRIUM;
        s = STATUS_OK;
    }
    if (s == STATUS_TOO_MANY_STEPS) {
        r->end = BRANCH_STEPS;
        s = STATUS_OK;
    }
    return s;
}

/* The whole branch with steps of a tolerance.  The caller frees r->flow in any
 * case. */
static enum status run(struct route *r, const struct frame *g, double step_rtol,
                       double guess, const struct eigen_options *o)
{
    memset(r, 0, sizeof *r);
    r->frame = g;
    r->end = BRANCH_DOMAIN;
    enum status s = find_start(g, step_rtol, guess, &r->start);
    if (s == STATUS_OK)
        s = begin(r, step_rtol, o->max_steps);
    if (s == STATUS_OK)
        s = follow(r, o->rtol, o->monitor);
    if (s != STATUS_OK)
        return s;
    const double *u = r->flow.u;
    r->limit =
        vec2_add(eigen_point(g->basis, (struct vec2){ u[0], u[1] }), r->rest);
    for (size_t i = 0; i < g->carry->count; i++)
        r->total[i] = u[i + 2] + r->total_rest[i];
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

/* The curve of a route from the saddle on, its points mapped by M. */
static enum status copy_curve(const struct route *r, struct mat2 M,
                              double error, struct curve *c)
{
    const struct start *t = &r->start;
    const double X = t->reach;
    double coef[CURVE_DIM_MAX][START_DEGREE + 1] = {
        { 0.0, X }, { 0.0, 0.0, t->c2 * X * X, t->c3 * X * X * X }
    };

    memcpy(coef[2], t->integral, sizeof t->integral);
    enum status s = append(c, START_DEGREE, coef[0], M, error);
    for (size_t i = 0; i < r->flow.curve.count && s == STATUS_OK; i++)
        s = append(c, r->flow.curve.piece[i].degree,
                   curve_component(&r->flow.curve, i, 0), M, error);
    return s;
}

/* Error of the finer run: its difference from the coarser one; a part of the
 * sum of its steps' own estimates, which are of order 5 only and many times
 * too large, but never zero by chance; the end; rounding. */
static double bar(double difference, double estimates, double rest,
                  double rounding)
{
    return fabs(difference) + TOL_EIGEN_ESTIMATES * estimates +
           TOL_EIGEN_RESTS * fabs(rest) +
           TOL_EIGEN_ROUNDING * DBL_EPSILON * rounding;
}

/* Of the coordinate that is not infinite, or not clamped to the edge. */
static void report_limit(const struct route *fine, const struct route *coarse,
                         struct branch *b)
{
    const struct mat2 P = fine->frame->basis;
    const double *u = fine->flow.u, *e = fine->flow.error;
    const struct vec2 off = vec2_sub(fine->limit, coarse->limit);

    if (fine->ind == 1)
        b->error.x = bar(off.x, fabs(P.xx) * e[0] + fabs(P.xy) * e[1],
                         fine->rest.x, fabs(P.xx * u[0]) + fabs(P.xy * u[1]));
    else
        b->error.y = bar(off.y, fabs(P.yx) * e[0] + fabs(P.yy) * e[1],
                         fine->rest.y, fabs(P.yx * u[0]) + fabs(P.yy * u[1]));
    if (coarse->end != fine->end || coarse->ind != fine->ind)
        *(fine->ind == 1 ? &b->error.x : &b->error.y) = HUGE_VAL;
}

static void report_totals(const struct route *fine, const struct route *coarse,
                          struct branch *b)
{
    for (size_t i = 0; i < fine->frame->carry->count; i++) {
        const double total = fine->total[i];
        const bool converges = fine->frame->converges[i];
        b->from_saddle[i] = converges;
        b->total[i] = total;
        b->total_error[i] =
            bar(converges ? total - coarse->total[i] : 0.0,
                fine->flow.error[i + 2], fine->total_rest[i], fabs(total));
        if (coarse->end != fine->end)
            b->total_error[i] = HUGE_VAL;
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
    b->steps = fine->flow.steps + coarse->flow.steps;
    b->rejected = fine->flow.rejected + coarse->flow.rejected;
    b->evaluations = fine->flow.calls + coarse->flow.calls;
}

static bool good_options(const struct eigen_options *o, int side)
{
    return o->rtol > 0.0 && o->rtol < 1.0 && abs(side) == 1 &&
           o->carry.count <= LOCAL_CARRY_MAX;
}

enum status eigen_branch(const struct planar *sys, const struct equilibrium *e,
                         int side, const struct eigen_options *o,
                         struct eigen_branch *out)
{
    const double tol = TOL_EIGEN_STEP * o->rtol;
    const struct mat2 identity = { 1.0, 0.0, 0.0, 1.0 };
    struct frame g;
    struct route fine = { 0 }, coarse = { 0 };

    memset(out, 0, sizeof *out);
    if (!good_options(o, side))
        return STATUS_BAD_ARGUMENT;
    if (!(e->scaled[0] < 0.0 && e->scaled[1] >= 0.0))
        return STATUS_NOT_HYPERBOLIC;
    set_frame(&g, sys, e, side, &o->carry);
    out->basis = g.basis;
    out->curve = CURVE_EMPTY(2 + o->carry.count);
    out->branch = (struct branch){ .kind = MANIFOLD_STABLE,
                                   .side = side,
                                   .carry = o->carry,
                                   .curve = out->curve };
    enum status s =
        run(&coarse, &g, TOL_EIGEN_COARSE * tol, TOL_EIGEN_START, o);
    if (s == STATUS_OK)
        s = run(&fine, &g, tol, 0.5 * fabs(coarse.start.reach), o);
    if (s != STATUS_OK)
        goto out;
    report(&fine, &coarse, &out->branch);
    const double error = fmax(out->branch.error.x, out->branch.error.y);
    s = copy_curve(&fine, identity, error, &out->curve);
    if (s == STATUS_OK)
        s = copy_curve(&fine, g.basis, error, &out->branch.curve);
out:
    flow_free(&fine.flow);
    flow_free(&coarse.flow);
    if (s != STATUS_OK)
        eigen_branch_free(out);
    return s;
}

void eigen_branch_free(struct eigen_branch *b)
{
    curve_free(&b->curve);
    branch_free(&b->branch);
}
