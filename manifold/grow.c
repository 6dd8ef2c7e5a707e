/*
 * Taylor steps on the graph of a stable manifold.  Method: the slope
 * S = f_dep/f_ind is built order by order with the graph itself (Jorba & Zou,
 * Exp. Math. 14 (2005) 99-117); step from the last two coefficients.
 * What we changed: dep is y while the curve is flatter than TOL_SLOPE_STEEP
 * and x above, so vertical walls cost nothing; each step's end is checked
 * against the field, because near a fold the coefficients alone deceive, and
 * that defect is the step's error; it is carried on by the linearised
 * equation, to the curve's end and into the integrals, so that the bar is
 * about the result; what remains of a branch that approaches an asymptote is
 * closed by quadrature (close.c) instead of being crawled along.  Branches step
 * together, also those of several systems, each with steps of its own length.
 */
#include "grow.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "grow_end.h"
#include "grow_error.h"
#include "grow_step.h"
#include "many.h"
#include "tolerance.h"

size_t grow_order(double rtol)
{
    const double order = TOL_ORDER_BASE - TOL_ORDER_PER_DIGIT * log10(rtol);
    return (size_t) fmin(fmax(order, 6.0), JET_SIZE - 1);
}

struct grow_options grow_defaults(double rtol)
{
    return (struct grow_options){ .rtol = rtol,
                                  .order = grow_order(rtol),
                                  .max_steps = TOL_BRANCH_STEPS };
}

/* As long as a long step, which powers of 2 keep. */
static double unit_of(double step)
{
    return step > 1.0 / TOL_SAME ? ldexp(1.0, ilogb(step)) : 1.0;
}

/* Over another coordinate, or leaning otherwise.  Keeps the outward sense. */
static void turn(struct grower *g, int ind, double lean)
{
    const struct vec2 f = g->end.J.field.direction;
    const struct vec2 off = local_point(g->ind, -g->lean, 1.0);
    const double before = grower_along(g, f);

    g->ind = ind;
    g->lean = lean;
    const double rate = grower_along(g, f) / before;
    const double ahead = grower_along(g, off) / rate;
    const double dep = vec2_part(f, 1 - ind) / before;
    grow_error_turn(g, vec2_part(off, 1 - ind) - dep * ahead, ahead);
    g->toward = rate >= 0.0 ? g->toward : -g->toward;
    g->last *= fabs(rate);
    grow_error_look(g, g->z);
}

/* By how much a graph that is to end leans, for who wants its end alone.  Where
 * dep grows like e^(k ind)/k into a wall, as of y = -ln(1 - e^(k x))/k, the
 * graph's steps are short for the wall, log(1 + k/slope)/k away, and those of
 * the other one for the foot; over ind + dep/k no singularity is nearer than
 * pi/k, at y' = -k.  So it leans while the wall is nearer than that, until the
 * other one is flat. */
static double lean_of(const struct grower *g)
{
    const struct vec2 f = g->end.J.field.direction;
    const double slope = vec2_part(f, 1 - g->ind) / vec2_part(f, g->ind);
    const double bend = g->out.slope_i + g->out.slope_d * slope;
    const double lean =
        g->lean == 0.0 ? g->toward * fabs(slope) / bend : g->lean;
    const double part = slope * lean;

    return g->o->bare && !g->o->follower && g->unit == 1.0 && part > 0.0 &&
                   part < TOL_SLOPE_STEEP && log1p(1.0 / part) < M_PI &&
                   grower_room(g) > 2.0 * g->last
               ? lean
               : 0.0;
}

/* y(x) or x(y)? */
static void choose_graph(struct grower *g)
{
    const double dx = g->end.J.field.direction.x,
                 dy = g->end.J.field.direction.y;
    const double far = fmax(1.0, fabs(g->z.y) / TOL_SLOPE_FAR);
    const double steep =
        g->ind == 0 && g->lean == 0.0 ? TOL_SLOPE_STEEP : TOL_SLOPE_FLAT;
    const int now = fabs(dy) < steep * far * fabs(dx) ? 0 : 1;
    const double lean = lean_of(g);

    if (lean != 0.0 || now == g->ind) {
        if (lean != g->lean)
            turn(g, g->ind, lean);
        return;
    }
    turn(g, now, 0.0);
    if (g->unit >= 1.0)
        g->unit = far > 1.0 ? unit_of(g->last) : 1.0;
}

/* Whether both go by series of one order that carry the same, of planes that
 * are alike. */
static bool is_alike(const struct grower *g, const struct grower *other)
{
    return g->kin == other->kin && g->o->order == other->o->order &&
           many_carry_alike(g->carry, other->carry);
}

/* How many of the first of n are. */
static size_t count_alike(struct grower *const g[], size_t n)
{
    size_t count = 1;

    while (count < n && is_alike(g[0], g[count]))
        count++;
    return count;
}

/* The next steps' series, of planes that are alike. */
static void expand(struct grower *const g[], size_t n)
{
    const struct grow_options *o = g[0]->o;
    const struct planar *sys[GROWERS];
    struct graph_start start[GROWERS];
    struct graph_series *u[GROWERS];

    for (size_t i = 0; i < n; i++) {
        sys[i] = g[i]->sys;
        start[i] =
            (struct graph_start){ g[i]->z, g[i]->ind, g[i]->lean, g[i]->unit };
        u[i] = &g[i]->u;
        g[i]->order = o->order;
        g[i]->b->evaluations++;
    }
    for (size_t i = 0; i < n;)
        i += graph_expand(sys + i, g[0]->carry, o->order, n - i, start + i,
                          u + i);
}

/* Writes u(s theta), with `start` for its constant, as polynomial in theta;
 * power[k] = s^k. */
static void store_series(const double u[], size_t order, double start,
                         const double power[], double coef[])
{
    coef[0] = start;
    for (size_t k = 1; k <= order; k++)
        coef[k] = u[k] * power[k];
}

static enum status store_step(struct grower *g)
{
    const size_t n = g->o->bare ? 0 : g->order;
    const double s = g->toward * g->h;
    double power[JET_SIZE] = { 1.0 }, *coef;
    const enum status status = branch_push(g->b, n, &g->piece, &coef);

    if (status != STATUS_OK)
        return status;
    for (size_t k = 1; k <= n; k++)
        power[k] = power[k - 1] * s;
    g->b->curve.piece[g->b->curve.count - 1].error = g->worst;
    store_series(g->u.at[0], n, g->u.at[0][0], power, coef);
    store_series(g->u.at[1], n, g->u.at[1][0], power, coef + (n + 1));
    for (size_t i = 0; i < g->carry->count; i++)
        store_series(g->u.integral[i], n, g->total[i], power,
                     coef + (i + 2) * (n + 1));
    g->piece = (struct branch_miss){ .grown = 1.0 };
    return STATUS_OK;
}

/* To the end of the step. */
static void move(struct grower *g)
{
    g->z = g->at_end;
    for (size_t i = 0; i < g->carry->count; i++)
        g->total[i] += g->integral_end[i].value;
}

static void advance(struct grower *g)
{
    move(g);
    g->last = g->unit * g->h;
    g->unit = g->unit < 1.0 ? fmin(ldexp(g->unit, ilogb(g->h)), 1.0)
                            : unit_of(g->last);
    g->b->steps++;
}

/* Where the branch ends after a step: on an edge, by itself or by its
 * follower. */
static void look_for_end(struct grower *g, bool edge)
{
    const struct grow_follower *f = g->o->follower;
    const bool upright = f == NULL && g->lean == 0.0;

    g->done = f ? f->ends(f->ctx, g->b, g->z, g->worst)
                : upright && grow_end_close(g);
    if (f && g->done)
        g->b->end = BRANCH_EQUILIBRIUM;
    if (!g->done &&
        (edge || (upright && grow_end_is_open(g)) ||
         !box_holds(g->sys->domain, vec2_add(g->sys->origin, g->z)))) {
        g->b->end = BRANCH_DOMAIN;
        g->done = true;
    }
    if (g->b->steps == g->o->max_steps)
        g->done = true;
}

/* One accepted step by the series expanded; g->done when the branch has
 * ended. */
static enum status step(struct grower *g)
{
    while (!g->holds) {
        g->h *= 0.5;
        g->edge = false;
        g->b->rejected++;
        if (!(g->unit * g->h >
              4.0 * DBL_EPSILON * (g->unit + fabs(g->u.at[g->ind][0])))) {
            g->done = g->o->follower != NULL;
            return g->done ? STATUS_OK : STATUS_NO_CONVERGENCE;
        }
        grow_step_try(&g, 1);
    }
    grow_error_step(g);
    const enum status s = store_step(g);
    if (s != STATUS_OK)
        return s;
    advance(g);
    look_for_end(g, g->edge);
    return !g->done && g->b->steps % TOL_MONITOR_STEPS == 0 &&
                   monitor_tell(g->o->monitor, "manifold", g->b->steps, 0)
               ? STATUS_STOPPED
               : STATUS_OK;
}

static enum status start_branch(struct grower *g, const struct local_series *u,
                                int side)
{
    *g->b = (struct branch){ .kind = MANIFOLD_STABLE,
                             .side = side,
                             .carry = *g->carry,
                             .curve = CURVE_EMPTY(2 + g->carry->count),
                             .end = BRANCH_STEPS };
    g->piece = (struct branch_miss){ .grown = 1.0 };
    g->u.at[u->ind][1] = u->unit;
    memcpy(g->u.at[1 - u->ind], u->c, sizeof u->c);
    for (size_t i = 0; i < g->carry->count; i++) {
        memcpy(g->u.integral[i], u->integral[i], sizeof u->integral[i]);
        g->b->from_saddle[i] = u->converges[i];
    }
    g->ind = u->ind;
    g->toward = side;
    g->unit = u->unit;
    g->h = u->radius;
    g->order = u->order;
    grow_step_look(&g, 1);
    g->out = (struct outward){ 0 };
    grow_error_step(g);
    const enum status status = store_step(g);
    if (status != STATUS_OK)
        return status;
    move(g);
    g->last = HUGE_VAL;
    if (g->o->follower)
        look_for_end(g, false);
    else
        g->done = g->o->max_steps == 0;
    return STATUS_OK;
}

static void finish(struct grower *g)
{
    struct branch *b = g->b;

    if (g->lean != 0.0)
        turn(g, g->ind, 0.0);
    b->limit = g->z;
    b->limit_off = g->miss.off;
    *(g->ind == 1 ? &b->error.x : &b->error.y) = grow_error_bound(&g->miss);
    for (size_t i = 0; i < g->carry->count; i++) {
        b->total[i] = g->total[i];
        b->total_off[i] = g->total_miss[i].off;
        b->total_error[i] = grow_error_bound(&g->total_miss[i]) + INTEGRAL_NIL;
    }
}

/* The next step of all that are not done; returns how many these are. */
static size_t step_all(struct grower g[], size_t n)
{
    struct grower *busy[GROWERS];
    size_t count = 0;

    for (int carries = 1; carries >= 0; carries--)
        for (size_t i = 0; i < n; i++)
            if (!g[i].done && (g[i].carry->count > 0) == carries) {
                choose_graph(&g[i]);
                busy[count++] = &g[i];
            }
    for (size_t i = 0, some; i < count; i += some) {
        some = count_alike(&busy[i], count - i);
        expand(&busy[i], some);
        grow_step_choose(&busy[i], some);
        grow_step_try(&busy[i], some);
    }
    for (size_t i = 0; i < count; i++)
        busy[i]->failed = step(busy[i]);
    return count;
}

static void begin(struct grower *g, const struct grow_job *job, int i)
{
    static const struct carry none = { .count = 0 };
    const struct grow_options *o = job->options;
    const bool carries = job->carries * (i == 0 ? 1 : -1) >= 0;
    const struct carry *carry = carries ? &o->carry : &none;

    job->out[i] = (struct branch){ .curve = CURVE_EMPTY(2 + carry->count) };
    *g = (struct grower){ .sys = job->sys,
                          .o = o,
                          .carry = carry,
                          .b = &job->out[i],
                          .tol = TOL_TAYLOR_STEP * o->rtol };
}

/* A job's branches stop together. */
static void stop_failed(struct grower g[2])
{
    for (int i = 0; i < 2; i++)
        if (g[i].failed) {
            g[0].done = g[1].done = true;
            g[1 - i].failed = g[0].failed ? g[0].failed : g[1].failed;
        }
}

static void start(struct grower g[2], const struct grow_job *job)
{
    for (int i = 0; i < 2; i++) {
        begin(&g[i], job, i);
        g[i].done = job->side * (i == 0 ? 1 : -1) < 0;
    }
    for (int i = 0; i < 2; i++)
        if (!g[i].done)
            g[i].failed = start_branch(&g[i], job->start, i == 0 ? 1 : -1);
    stop_failed(g);
}

static enum status end(struct grower g[2], const struct grow_job *job)
{
    for (int i = 0; i < 2; i++)
        if (g[i].failed || job->side * (i == 0 ? 1 : -1) < 0)
            branch_free(g[i].b);
        else
            finish(&g[i]);
    return g[0].failed;
}

/* Of job i's branches. */
static int kin_of(const struct grow_job job[], size_t i)
{
    size_t first = 0;

    while (!many_alike(job[first].sys, job[i].sys))
        first++;
    return (int) first;
}

void grow_jobs(struct grow_job job[], size_t n)
{
    struct grower g[GROWERS];

    for (size_t i = 0; i < n; i++) {
        start(&g[2 * i], &job[i]);
        g[2 * i].kin = g[2 * i + 1].kin = kin_of(job, i);
    }
    while (step_all(g, 2 * n) > 0)
        for (size_t i = 0; i < n; i++)
            stop_failed(&g[2 * i]);
    for (size_t i = 0; i < n; i++)
        job[i].status = end(&g[2 * i], &job[i]);
}

enum status grow_branches(const struct planar *sys,
                          const struct local_series *start,
                          const struct grow_options *o, struct branch out[2])
{
    struct grow_job job = { sys, start, o, 0, 0, out, STATUS_OK };

    grow_jobs(&job, 1);
    return job.status;
}

enum status grow_branch(const struct planar *sys,
                        const struct local_series *start, int side,
                        const struct grow_options *o, struct branch *out)
{
    struct branch both[2];
    struct grow_job job = { sys, start, o, side, 0, both, STATUS_OK };

    grow_jobs(&job, 1);
    *out = both[side > 0 ? 0 : 1];
    return job.status;
}
