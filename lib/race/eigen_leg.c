#include "eigen_leg.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "eigen_tolerance.h"

static struct vec2 point_of(const struct eigen_leg *l, const double u[])
{
    return eigen_point(l->map, (struct vec2){ u[0], u[1] });
}

/* Unit speed outwards, against the field. */
static void unit_speed(const void *ctx, double s, const double u[], double du[])
{
    const struct eigen_leg *l = ctx;
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
    const struct eigen_leg *l = ctx;
    const struct planar *sys = l->frame->sys;
    const struct box d = sys->domain;
    const struct vec2 z = vec2_add(sys->origin, point_of(l, u));

    (void) s;
    return fmin(fmin(z.x - d.lo.x, d.hi.x - z.x),
                fmin(z.y - d.lo.y, d.hi.y - z.y));
}

static struct mat2 scaled(double k, struct mat2 M)
{
    return (struct mat2){ k * M.xx, k * M.xy, k * M.yx, k * M.yy };
}

/* From u on; atol: of u[0] and u[1]. */
static enum status begin(struct eigen_leg *l, const double u[],
                         const double atol[2], size_t max_steps)
{
    const size_t n = l->frame->carry->count;
    struct flow_options o = { .rtol = l->rtol,
                              .atol = { atol[0], atol[1] },
                              .first_step = 0.25,
                              .max_steps = max_steps,
                              .event = &l->edge,
                              .events = 1 };
    double du[CURVE_DIM_MAX];

    unit_speed(l, 0.0, u, du);
    for (size_t i = 0; i < n; i++)
        o.atol[i + 2] = l->rtol * fabs(du[i + 2]) + DBL_MIN;
    l->ode = (struct ode){ 2 + n, unit_speed, l };
    l->edge = (struct event){ depth, l, -1, true };
    return flow_init(&l->flow, &l->ode, 0.0, u, &o);
}

enum status eigen_leg_begin(struct eigen_leg *l, const struct eigen_frame *g,
                            const struct eigen_start *t, double rtol,
                            size_t max_steps)
{
    const double none[2] = { DBL_MIN, DBL_MIN }, unit = fabs(t->reach);
    double u[CURVE_DIM_MAX] = { copysign(1.0, t->reach) };

    u[1] = eigen_start_point(t, 1.0).y / unit;
    for (size_t i = 0; i < g->carry->count; i++) {
        const double *c = t->integral[i];
        u[i + 2] = c[1] + c[2] + c[3];
    }
    *l = (struct eigen_leg){
        .frame = g, .map = scaled(unit, g->basis), .in_W = true, .rtol = rtol
    };
    eigen_drift_begin(&l->drift, g, l->map, u);
    l->drift.normal = rtol * (fabs(u[1]) + g->thin);
    return begin(l, u, none, max_steps);
}

enum status eigen_leg_turn(struct eigen_leg *l, const struct eigen_leg *from)
{
    const struct mat2 identity = { 1.0, 0.0, 0.0, 1.0 };
    const struct vec2 z = eigen_leg_end(from);
    const double unit = vec2_length(z);
    double u[CURVE_DIM_MAX];

    *l = (struct eigen_leg){ .frame = from->frame,
                             .map = scaled(unit, identity),
                             .rtol = from->rtol,
                             .drift = from->drift };
    memcpy(u, from->flow.u, sizeof u);
    u[0] = z.x / unit;
    u[1] = z.y / unit;
    const double atol[2] = { l->rtol * fabs(u[0]) + DBL_MIN,
                             l->rtol * fabs(u[1]) + DBL_MIN };
    eigen_drift_turn(&l->drift, l->frame, l->map, u);
    return begin(l, u, atol, from->flow.options.max_steps);
}

struct vec2 eigen_leg_end(const struct eigen_leg *l)
{
    return point_of(l, l->flow.u);
}

double eigen_leg_cancellation(const struct eigen_leg *l)
{
    const struct mat2 M = l->map;
    const double *u = l->flow.u;
    const struct vec2 z = eigen_leg_end(l);
    const double x = fabs(M.xx * u[0]) + fabs(M.xy * u[1]);
    const double y = fabs(M.yx * u[0]) + fabs(M.yy * u[1]);

    return fmax(fmax(x / fabs(z.x), y / fabs(z.y)), 1.0);
}

/* Error weights that follow the curve, and the longest step. */
static void set_weights(struct eigen_leg *l)
{
    struct flow *f = &l->flow;
    const double pace = vec2_length(point_of(l, f->work.k[0]));

    f->options.rtol = l->rtol / fmin(eigen_leg_cancellation(l), TOL_EIGEN_LOST);
    if (l->in_W)
        f->options.atol[1] =
            f->options.rtol * l->frame->thin * fabs(f->u[0]) + DBL_MIN;
    for (size_t i = 0; i < l->frame->carry->count; i++)
        f->options.atol[i + 2] =
            fmax(f->options.atol[i + 2],
                 TOL_ROUNDINGS_MANY * l->drift.noise[i] * (1.0 + f->s));
    const double far = TOL_EIGEN_STRIDE * vec2_length(eigen_leg_end(l));
    f->h = fmin(f->h, fmax(TOL_EIGEN_LONGEST, far) / pace);
}

/* How far the last step's polynomial is from a solution between its stages: a
 * bend that they all missed shows there.  h times the difference. */
static void find_defect(const struct eigen_leg *l, double h, double defect[])
{
    static const double theta[] = { 0.47, 0.93 };
    const struct curve *c = &l->flow.curve;
    double at[CURVE_DIM_MAX], slope[CURVE_DIM_MAX], field[CURVE_DIM_MAX];

    memset(defect, 0, l->ode.dim * sizeof *defect);
    for (int k = 0; k < 2; k++) {
        curve_at(c, c->count - 1, theta[k], at);
        curve_slope_at(c, c->count - 1, theta[k], slope);
        unit_speed(l, 0.0, at, field);
        for (size_t i = 0; i < l->ode.dim; i++)
            defect[i] = fmax(defect[i], fabs(slope[i] - h * field[i]));
    }
}

/* The largest defect, in tolerances. */
static double bend(const struct eigen_leg *l, const double defect[])
{
    const struct flow_options *o = &l->flow.options;
    double worst = 0.0;

    for (size_t i = 0; i < l->ode.dim; i++) {
        const double size = o->atol[i] + o->rtol * fabs(l->flow.u[i]);
        worst = defect[i] <= worst * size ? worst : defect[i] / size;
    }
    return worst;
}

/* Undoes the last step, the next one to be of length h; the arrays may have
 * moved meanwhile. */
static void take_back(struct flow *f, const struct flow *before, double h)
{
    const struct flow after = *f;

    *f = *before;
    f->curve = after.curve;
    f->curve.count = before->curve.count;
    f->curve.coefs = before->curve.coefs;
    f->log.hit = after.log.hit;
    f->log.room = after.log.room;
    f->calls = after.calls;
    f->rejected = after.rejected + 1;
    f->h = h;
}

/* A step without bends that its estimates missed; what halving it hardly
 * changes is rounding. */
static enum status step(struct eigen_leg *l, double defect[])
{
    const struct flow before = l->flow;
    double most = HUGE_VAL;

    for (;;) {
        const enum status s = flow_step(&l->flow, HUGE_VAL);
        if (s != STATUS_OK)
            return s;
        const double h = l->flow.s - before.s;
        find_defect(l, h, defect);
        const double off = bend(l, defect);
        if (l->flow.end == FLOW_EVENT || off <= TOL_EIGEN_DEFECT ||
            !(off < 0.5 * most))
            return STATUS_OK;
        most = off;
        take_back(&l->flow, &before, 0.5 * h);
    }
}

enum status eigen_leg_step(struct eigen_leg *l)
{
    const double s = l->flow.s;
    const struct eigen_drift drift = l->drift;
    double before[CURVE_DIM_MAX], defect[CURVE_DIM_MAX], error[CURVE_DIM_MAX];

    memcpy(before, l->flow.error, sizeof before);
    set_weights(l);
    const enum status status = step(l, defect);
    if (status != STATUS_OK)
        return status;
    for (size_t i = 0; i < l->ode.dim; i++)
        error[i] =
            TOL_EIGEN_ESTIMATES * (defect[i] + l->flow.error[i] - before[i]);
    eigen_drift_step(&l->drift, l->frame, l->flow.s - s, l->flow.u, error);
    l->flow.curve.piece[l->flow.curve.count - 1].error =
        eigen_drift_of_piece(&drift, &l->drift, defect);
    return STATUS_OK;
}

void eigen_leg_free(struct eigen_leg *l)
{
    flow_free(&l->flow);
}
