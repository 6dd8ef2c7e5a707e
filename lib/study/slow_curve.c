/* A branch leaves the saddle on either side; beyond each node one starts where
 * the coordinate that settles first has settled, as far out as the rates are
 * apart, and is used from where any orbit would have landed on it. */
#include "slow_curve.h"

#include <math.h>

#include "local.h"
#include "study.h"
#include "study_tolerance.h"

/* ---- where branches start ------------------------------------------------ */

/* One more branch of c from the offset z; dropped where it is none. */
static enum status add(struct slow_curve *c, struct vec2 z, bool from_saddle,
                       const struct monitor *monitor)
{
    struct slow_branch *b = &c->branch[c->branches];
    const enum status status =
        slow_branch_run(c->study, z, from_saddle, monitor, b);

    if (status == STATUS_OK && b->count > 2 && b->fate != FATE_UNDECIDED)
        c->branches++;
    else
        slow_branch_free(b);
    return status;
}

static enum status add_unstable(struct slow_curve *c,
                                const struct monitor *monitor)
{
    const struct study *s = c->study;
    const struct equilibrium *saddle = &s->equilibrium[s->saddle];
    const struct carry none = { .count = 0 };
    struct local_series u;
    enum status status = local_at(&s->system, saddle, MANIFOLD_UNSTABLE, &none,
                                  TOL_SLOW_ORDER, TOL_SLOW_RTOL, &u);

    if (status != STATUS_OK)
        return status == STATUS_NO_MEMORY ? status : STATUS_OK;
    const double start = fmin(u.radius, TOL_SLOW_START / u.unit);
    for (int side = -1; side <= 1 && status == STATUS_OK; side += 2) {
        const struct vec2 z = local_series_at(&u, side * start);
        const size_t before = c->branches;
        if (z.x < 0.0 || !c->runs_away)
            status = add(c, z, true, monitor);
        if (c->branches > before)
            c->branch[before].grows = saddle->lambda[1];
    }
    return status;
}

/* The field's components on the chart's lines, divided by what keeps them
 * finite. */
static double component(const struct study *s, int which, struct vec2 z)
{
    struct planar_field f;

    s->system.field(s->system.ctx, z, &f);
    return which == 0 ? f.direction.x : f.direction.y;
}

/* Component `which` vanishes where its own coordinate is right, for both pull
 * back: into *z between the ends of the domain.  False: it does not. */
static bool settle(const struct study *s, int which, struct vec2 *z)
{
    const struct box d = s->system.domain;
    double *const at = which == 0 ? &z->x : &z->y;
    double lo =
        which == 0 ? d.lo.x - s->system.origin.x : d.lo.y - s->system.origin.y;
    double hi =
        which == 0 ? d.hi.x - s->system.origin.x : d.hi.y - s->system.origin.y;
    const double low = lo, high = hi;

    for (int i = 0; i < TOL_SLOW_HALVINGS; i++) {
        *at = 0.5 * (lo + hi);
        if (component(s, which, *z) > 0.0)
            lo = *at;
        else
            hi = *at;
    }
    return lo > low && hi < high;
}

/* The furthest point beside a node, on the side of y, that the coordinate
 * `fast` settles on while the rates are apart. */
static bool furthest(const struct study *s, struct vec2 node, int fast,
                     double side, struct vec2 *start)
{
    bool found = false;

    for (double way = TOL_SLOW_NEAREST; way < TOL_SLOW_FURTHEST;
         way *= TOL_SLOW_STRIDE) {
        struct vec2 z = { node.x - side * way, node.y + side * way };
        if (settle(s, fast, &z) && slow_branch_may_start(s, fast, z)) {
            *start = z;
            found = true;
        }
    }
    return found;
}

static enum status add_beyond(struct slow_curve *c, struct vec2 node,
                              double side, const struct monitor *monitor)
{
    struct vec2 z[2];
    const bool is[2] = { furthest(c->study, node, 0, side, &z[0]),
                         furthest(c->study, node, 1, side, &z[1]) };
    const bool second = is[1] && (!is[0] || (z[1].y - z[0].y) * side > 0.0);

    return is[0] || is[1] ? add(c, z[second], false, monitor) : STATUS_OK;
}

/* On the sides of each node that no saddle is on. */
static enum status add_nodes(struct slow_curve *c,
                             const struct monitor *monitor)
{
    const struct study *s = c->study;
    enum status status = STATUS_OK;

    for (size_t i = 0; i < s->equilibria && status == STATUS_OK; i++) {
        const struct equilibrium *e = &s->equilibrium[i];
        const struct vec2 node = vec2_sub(e->z, s->system.origin);
        if (e->type != EQUILIBRIUM_STABLE_NODE)
            continue;
        for (int side = -1; side <= 1 && status == STATUS_OK; side += 2) {
            const bool taken = s->saddle >= 0 && side * node.y < 0.0;
            if (!taken && c->branches < SLOW_BRANCHES)
                status = add_beyond(c, node, side, monitor);
        }
    }
    return status;
}

/* Further down where the saddle's manifold comes to rest. */
static enum status add_rest(struct slow_curve *c, const struct monitor *monitor)
{
    for (size_t i = 0; i < c->branches; i++) {
        const struct slow_branch *b = &c->branch[i];
        const struct slow_knot *last = &b->knot[b->count - 1];
        if (b->fate == FATE_REST_FINITE)
            return rest_curve_run(c->study, (struct vec2){ last->x, last->y },
                                  monitor, &c->rest);
    }
    return STATUS_OK;
}

/* Of what can land on a branch. */
static void find_least(struct slow_curve *c)
{
    c->time_least = c->slip_least = HUGE_VAL;
    for (size_t i = 0; i < c->branches; i++) {
        const struct slow_branch *b = &c->branch[i];
        const double end = b->knot[b->count - 1].y;
        c->rests = c->rests || b->fate == FATE_REST_FINITE;
        for (size_t k = 0; k < b->count; k++) {
            if (fabs(b->knot[k].y - end) < TOL_SLOW_CLEAR)
                break;
            c->time_least = fmin(c->time_least, b->knot[k].time[0]);
            c->slip_least = fmin(c->slip_least, b->knot[k].slip[0]);
        }
    }
}

enum status slow_curve_init(struct slow_curve *c, const struct study *s,
                            const struct monitor *monitor)
{
    enum status status = STATUS_OK;

    *c = (struct slow_curve){ .study = s, .rests = s->saddle == 0 };
    c->runs_away = s->saddle >= 0 && (size_t) s->saddle + 1 == s->equilibria;
    if (s->equilibria > SLOW_BRANCHES - 1)
        return STATUS_OK;
    if (s->saddle >= 0)
        status = add_unstable(c, monitor);
    if (status == STATUS_OK)
        status = add_nodes(c, monitor);
    if (status == STATUS_OK)
        status = add_rest(c, monitor);
    find_least(c);
    if (status != STATUS_OK)
        slow_curve_free(c);
    return status;
}

/* ---- points -------------------------------------------------------------- */

/* What hardly changes within an interval is its first knot's. */
static struct slow_point common(const struct slow_branch *b,
                                const struct slow_knot *k,
                                const struct slow_knot *next)
{
    return (struct slow_point){
        .fate = b->fate,
        .time_error = k->time_bar + next->time_error,
        .slip_error = k->slip_bar + next->slip_error,
        .x_slope = k->x_slope,
        .fast = k->fast,
        .gap = fmax(k->gap, next->gap),
        .fibre = k->fibre,
        .x_end = b->x_end,
        .x_peak = next->x_peak,
        .mu_peak = next->mu_peak,
    };
}

/* Whether y lies between the saddle and the first knot. */
static bool near_saddle(const struct slow_branch *b, double y)
{
    const double part = y / b->knot->y;

    return b->from_saddle && part > 0.0 && part < 1.0;
}

/* There T' = 1/(lambda y) + what is the same
 * as at the knot. */
static bool at_saddle(const struct slow_branch *b, double y, double v,
                      struct slow_point *p)
{
    const struct slow_knot *k = b->knot;

    if (!near_saddle(b, y))
        return false;
    const double fold = log(k->y / y) / b->grows;
    const double time_rest = k->time[1] + 1.0 / (b->grows * k->y);
    const double slip_rest = k->slip[1] + v / (b->grows * k->y);
    *p = common(b, k, k + 1);
    p->x = k->x / k->y * y;
    p->time = k->time[0] + fold + time_rest * (y - k->y);
    p->slip = k->slip[0] + v * fold + slip_rest * (y - k->y);
    p->time_slope = -1.0 / (b->grows * y) + time_rest;
    p->slip_slope = -v / (b->grows * y) + slip_rest;
    p->time_error += fabs(time_rest * k->y * k->y);
    p->slip_error += fabs(slip_rest * k->y * k->y);
    return true;
}

/* x between knot f and the next. */
static double x_inside(const struct slow_knot *f, double y, double *slope)
{
    const struct slow_knot *g = f + 1;
    const double h = g->y - f->y, t = (y - f->y) / h;
    const double rise = g->x - f->x;
    const double f1 = h * f->x_slope - rise, g1 = h * g->x_slope - rise;

    *slope = f->x_slope + t * (g->x_slope - f->x_slope);
    return f->x + t * rise + t * (1.0 - t) * ((1.0 - t) * f1 - t * g1);
}

static void inside(const struct slow_branch *b, size_t i, double y,
                   struct slow_point *p)
{
    const struct slow_knot *f = &b->knot[i - 1], *g = &b->knot[i];
    const double h = g->y - f->y, t = (y - f->y) / h;

    *p = common(b, f, g);
    p->x = x_inside(f, y, &p->x_slope);
    p->fast += t * (g->fast - f->fast);
    p->fibre.x += t * (g->fibre.x - f->fibre.x);
    p->fibre.y += t * (g->fibre.y - f->fibre.y);
    p->time = slow_quintic(f->time, g->time, h, t, &p->time_slope);
    p->slip = slow_quintic(f->slip, g->slip, h, t, &p->slip_slope);
}

bool slow_curve_beside(const struct slow_curve *c, double y, double *x,
                       double *x_slope)
{
    for (size_t i = 0; i < c->branches; i++) {
        const struct slow_branch *b = &c->branch[i];
        const size_t k = slow_branch_interval(b, y);
        if (k > 0 && isfinite(b->knot[k - 1].gap) && isfinite(b->knot[k].gap)) {
            *x = x_inside(&b->knot[k - 1], y, x_slope);
            return true;
        }
        if (near_saddle(b, y)) {
            *x_slope = b->knot->x / b->knot->y;
            *x = *x_slope * y;
            return true;
        }
    }
    return false;
}

bool slow_curve_at(const struct slow_curve *c, double y, struct slow_point *p)
{
    for (size_t i = 0; i < c->branches; i++) {
        const struct slow_branch *b = &c->branch[i];
        const size_t k = slow_branch_interval(b, y);
        if (k > 0 && isfinite(b->knot[k - 1].gap) && isfinite(b->knot[k].gap)) {
            inside(b, k, y, p);
            return true;
        }
        if (at_saddle(b, y, c->study->block.at.v0, p))
            return true;
    }
    return false;
}

void slow_curve_free(struct slow_curve *c)
{
    for (size_t i = 0; i < c->branches; i++)
        slow_branch_free(&c->branch[i]);
    rest_curve_free(&c->rest);
    c->branches = 0;
}
