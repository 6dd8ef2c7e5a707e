/* A branch leaves the saddle on either side; beyond each node one starts where
 * the coordinate that settles first has settled, as far out as the rates are
 * apart, and is used from where any orbit would have landed on it. */
#include "slow_curve.h"

#include <math.h>
#include <stdlib.h>

#include "slider.h"
#include "slow_tolerance.h"

/* ---- where branches start ------------------------------------------------ */

/* One more branch of c from the offset z; dropped where it is none. */
static enum status add(struct slow_curve *c, struct vec2 z,
                       enum slow_start start, const struct saddle_series *near,
                       const struct monitor *monitor)
{
    struct slow_branch *b = &c->branch[c->branches];
    const enum status status =
        slow_branch_run(c->slider, z, start, near, monitor, b);

    if (status == STATUS_OK && b->count > 2 && b->fate != FATE_UNDECIDED)
        c->branches++;
    else
        slow_branch_free(b);
    return status;
}

/* From where the saddle's series end. */
static enum status add_unstable(struct slow_curve *c,
                                const struct monitor *monitor)
{
    enum status status = STATUS_OK;
    struct vec2 away = { 0.0, 0.0 };

    c->near = malloc(sizeof *c->near);
    if (c->near == NULL)
        return STATUS_NO_MEMORY;
    if (saddle_series_find(c->slider, c->near) != STATUS_OK) {
        free(c->near);
        c->near = NULL;
        return STATUS_OK;
    }
    for (int side = 1; side >= -1 && status == STATUS_OK; side -= 2) {
        const double y = side * c->near->radius * c->near->unit;
        const struct vec2 z = { saddle_series_on(c->near, y).x, y };
        if (z.x < 0.0 || !c->runs_away)
            status = add(c, z, SLOW_SADDLE, c->near, monitor);
        else
            away = z;
    }
    if (status == STATUS_OK && c->branches > 0 && away.x > 0.0)
        status = slow_branch_run(c->slider, away, SLOW_RUNAWAY, c->near,
                                 monitor, &c->away);
    return status;
}

/* The field's components on the chart's lines, divided by what keeps them
 * finite. */
static double component(const struct slider *s, int which, struct vec2 z)
{
    struct planar_field f;

    s->plane.system.field(s->plane.system.ctx, z, &f);
    return which == 0 ? f.direction.x : f.direction.y;
}

/* Component `which` vanishes where its own coordinate is right, for both pull
 * back: into *z between the ends of the domain.  False: it does not. */
static bool settle(const struct slider *s, int which, struct vec2 *z)
{
    const struct box d = s->plane.system.domain;
    double *const at = which == 0 ? &z->x : &z->y;
    double lo = which == 0 ? d.lo.x - s->plane.system.origin.x
                           : d.lo.y - s->plane.system.origin.y;
    double hi = which == 0 ? d.hi.x - s->plane.system.origin.x
                           : d.hi.y - s->plane.system.origin.y;
    const double low = lo, high = hi;

    for (double last = hi; (*at = 0.5 * (lo + hi)) != last; last = *at) {
        if (component(s, which, *z) > 0.0)
            lo = *at;
        else
            hi = *at;
    }
    return lo > low && hi < high;
}

/* The furthest point beside a node, on the side of y, that the coordinate
 * `fast` settles on while the rates are apart. */
static bool furthest(const struct slider *s, struct vec2 node, int fast,
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
    const bool is[2] = { furthest(c->slider, node, 0, side, &z[0]),
                         furthest(c->slider, node, 1, side, &z[1]) };
    const bool second = is[1] && (!is[0] || (z[1].y - z[0].y) * side > 0.0);

    return is[0] || is[1] ? add(c, z[second], SLOW_BESIDE, NULL, monitor)
                          : STATUS_OK;
}

/* On the sides of each node that no saddle is on. */
static enum status add_nodes(struct slow_curve *c,
                             const struct monitor *monitor)
{
    const struct slider *s = c->slider;
    enum status status = STATUS_OK;

    for (size_t i = 0; i < s->plane.equilibria && status == STATUS_OK; i++) {
        const struct equilibrium *e = &s->plane.equilibrium[i];
        const struct vec2 node = vec2_sub(e->z, s->plane.system.origin);
        if (e->type != EQUILIBRIUM_STABLE_NODE)
            continue;
        for (int side = -1; side <= 1 && status == STATUS_OK; side += 2) {
            const bool taken = slider_saddle(s) >= 0 && side * node.y < 0.0;
            if (!taken && c->branches < SLOW_BRANCHES)
                status = add_beyond(c, node, side, monitor);
        }
    }
    return status;
}

/* The node whose box the branch ends at. */
static const struct equilibrium *end_of(const struct slider *s,
                                        const struct slow_branch *b)
{
    const struct slow_knot *k = &b->knot[b->count - 1];
    const struct vec2 o = s->plane.system.origin;
    const struct equilibrium *end = NULL;
    double way = HUGE_VAL;

    for (size_t i = 0; i < s->plane.equilibria; i++) {
        const struct vec2 e = s->plane.equilibrium[i].z;
        const double dx = fabs(k->x + o.x - e.x), dy = fabs(k->y + o.y - e.y);
        if ((int) i != slider_saddle(s) && fmax(dx, dy) < way) {
            way = fmax(dx, dy);
            end = &s->plane.equilibrium[i];
        }
    }
    return end;
}

/* From the faces of the boxes on. */
static enum status add_insides(struct slow_curve *c,
                               const struct monitor *monitor)
{
    const struct slider *s = c->slider;
    enum status status = STATUS_OK;

    for (size_t i = 0; i < c->branches && status == STATUS_OK; i++) {
        const struct slow_branch *b = &c->branch[i];
        const struct slow_knot *last = &b->knot[b->count - 1];
        if (b->x_end == -HUGE_VAL)
            continue;
        const struct equilibrium *node = end_of(s, b);
        status = slow_branch_run(s, (struct vec2){ last->x, last->y },
                                 SLOW_FACE, NULL, monitor, &c->inside[i]);
        c->inside[i].v_node = exp(node->z.x);
        c->inside[i].centre = node->z.y - s->plane.system.origin.y;
        c->inside[i].grows = node->lambda[1];
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
            return rest_curve_run(c->slider, (struct vec2){ last->x, last->y },
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
        c->rests = c->rests || b->x_end == -HUGE_VAL;
        for (size_t k = 0; k < b->count; k++) {
            if (fabs(b->knot[k].y - end) < TOL_SLOW_CLEAR)
                break;
            c->time_least = fmin(c->time_least, b->knot[k].time[0]);
            c->slip_least = fmin(c->slip_least, b->knot[k].slip[0]);
        }
    }
}

enum status slow_curve_init(struct slow_curve *c, const struct slider *s,
                            const struct monitor *monitor)
{
    enum status status = STATUS_OK;

    *c = (struct slow_curve){ .slider = s, .rests = slider_saddle(s) == 0 };
    c->runs_away = slider_saddle(s) >= 0 &&
                   (size_t) slider_saddle(s) + 1 == s->plane.equilibria;
    if (s->plane.equilibria > SLOW_BRANCHES - 1)
        return STATUS_OK;
    if (slider_saddle(s) >= 0)
        status = add_unstable(c, monitor);
    if (status == STATUS_OK)
        status = add_nodes(c, monitor);
    if (status == STATUS_OK)
        status = add_insides(c, monitor);
    if (status == STATUS_OK)
        status = add_rest(c, monitor);
    find_least(c);
    if (status != STATUS_OK)
        slow_curve_free(c);
    return status;
}

/* ---- points -------------------------------------------------------------- */

static bool is_beside(const struct slow_branch *b, double y, double *x,
                      double *x_slope)
{
    return b->count > 2 && slow_point_beside(b, y, x, x_slope);
}

bool slow_curve_beside(const struct slow_curve *c, double y, bool anywhere,
                       double *x, double *x_slope)
{
    for (size_t i = 0; i < c->branches; i++)
        if (slow_point_beside(&c->branch[i], y, x, x_slope) ||
            (anywhere && is_beside(&c->inside[i], y, x, x_slope)))
            return true;
    return anywhere && is_beside(&c->away, y, x, x_slope);
}

bool slow_curve_at(const struct slow_curve *c, double y, struct slow_point *p)
{
    for (size_t i = 0; i < c->branches; i++)
        if (slow_point_at(&c->branch[i], y, p) && isfinite(p->gap))
            return true;
    return false;
}

static bool is_on(const struct slow_branch *b, double y, struct slow_point *p)
{
    return b->count > 2 && slow_point_at(b, y, p);
}

bool slow_curve_anywhere(const struct slow_curve *c, double y,
                         struct slow_point *p)
{
    for (size_t i = 0; i < c->branches; i++)
        if (slow_point_at(&c->branch[i], y, p) || is_on(&c->inside[i], y, p))
            return true;
    return is_on(&c->away, y, p);
}

double slow_curve_when(const struct slow_curve *c, double y, double time)
{
    struct slow_point p;

    for (size_t i = 0; i < c->branches; i++) {
        const struct slow_branch *b = &c->branch[i], *in = &c->inside[i];
        if (slow_point_at(b, y, &p) || is_on(in, y, &p))
            return time >= 0.0     ? slow_point_when(b, time)
                   : in->count > 2 ? slow_point_when(in, time)
                                   : NAN;
    }
    return is_on(&c->away, y, &p) ? slow_point_when(&c->away, time) : NAN;
}

void slow_curve_free(struct slow_curve *c)
{
    for (size_t i = 0; i < SLOW_BRANCHES; i++) {
        slow_branch_free(&c->branch[i]);
        slow_branch_free(&c->inside[i]);
    }
    slow_branch_free(&c->away);
    free(c->near);
    c->near = NULL;
    rest_curve_free(&c->rest);
    c->branches = 0;
}
