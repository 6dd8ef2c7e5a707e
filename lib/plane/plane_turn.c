/* Orbits are followed so accurately that 1e5 times their steps' errors are
 * within what counts as off; signs are those of intervals over boxes, which are
 * halved where they do not tell. */
#include "plane_turn.h"

#include <math.h>
#include <stdlib.h>

#include "interval.h"
#include "plane_tolerance.h"
#include "room.h"
#include "taylor_orbit.h"

void plane_turn_free(struct plane_turn *t)
{
    free(t->at);
    *t = (struct plane_turn){ .at = NULL };
}

/* ---- places -------------------------------------------------------------- */

/* From u to the straight line from a to b. */
static double distance(struct vec2 a, struct vec2 b, struct vec2 u)
{
    const struct vec2 d = vec2_sub(b, a), w = vec2_sub(u, a);
    const double all = d.x * d.x + d.y * d.y;
    const double part =
        all > 0.0 ? fmin(fmax((d.x * w.x + d.y * w.y) / all, 0.0), 1.0) : 0.0;

    return vec2_length(vec2_sub(w, vec2_scale(part, d)));
}

/* Whether an offset is inside, or, on == true, may be: on the curve or in it.
 */
static bool is_inside(const struct plane_turn *t, struct vec2 u, bool on)
{
    const double off = on ? t->off : -t->off;
    bool inside = false, near = false;

    if (!(u.x >= t->box.lo.x - off && u.x <= t->box.hi.x + off &&
          u.y >= t->box.lo.y - off && u.y <= t->box.hi.y + off))
        return false;
    for (size_t i = 0, k = t->corners - 1; i < t->corners; k = i++) {
        const struct vec2 a = t->at[k], b = t->at[i];
        near = near || distance(a, b, u) <= t->off;
        if ((a.y > u.y) != (b.y > u.y) &&
            (vec2_cross(vec2_sub(b, a), vec2_sub(u, a)) > 0.0) == (b.y > a.y))
            inside = !inside;
    }
    return near ? on : inside;
}

bool plane_turn_holds(const struct plane_study *s, const struct plane_rest *r,
                      bool backward, struct vec2 z)
{
    const struct plane_turn *t = &r->turn[backward];

    return t->corners > 0 &&
           is_inside(t, arrival_from(&s->scale, z, r->z), false);
}

/* ---- signs --------------------------------------------------------------- */

/* A turn in the making about an absolute place; formulas of both rates and of
 * what is left of each once its own coordinate is taken out, if it shows that.
 */
struct turning {
    const struct plane_study *s;
    const struct plane_rest *r; /* NULL: no equilibrium */
    struct vec2 z;
    struct formula *graph;      /* owned */
    struct interval_plan *plan; /* owned */
    bool shows[2];
    bool backward;
    struct plane_turn *turn; /* borrowed */
};

/* A box of offsets, as states. */
static void states_of(const struct turning *g, struct box b,
                      struct interval_double out[2])
{
    const struct vec2 side = g->s->scale.side, z = g->z;

    out[0] =
        (struct interval_double){ plane_state(g->s, 0, z.x + b.lo.x * side.x),
                                  plane_state(g->s, 0, z.x + b.hi.x * side.x) };
    out[1] =
        (struct interval_double){ plane_state(g->s, 1, z.y + b.lo.y * side.y),
                                  plane_state(g->s, 1, z.y + b.hi.y * side.y) };
}

/* The two halves of a box across its longer side, or, if it is on both of its
 * sides, at the equilibrium: x (2 x) has one sign on either side of 0 alone. */
static void halve(struct box b, struct box half[2])
{
    const bool about_x = b.lo.x < 0.0 && b.hi.x > 0.0,
               about_y = b.lo.y < 0.0 && b.hi.y > 0.0;
    const struct vec2 m = vec2_scale(0.5, vec2_add(b.lo, b.hi));

    half[0] = half[1] = b;
    if (about_x || (!about_y && b.hi.x - b.lo.x > b.hi.y - b.lo.y))
        half[0].hi.x = half[1].lo.x = about_x ? 0.0 : m.x;
    else
        half[0].hi.y = half[1].lo.y = about_y ? 0.0 : m.y;
}

/* Whether orbits cross all of a part of the row upward (way 1) or downward. */
static bool crosses(struct turning *g, struct box b, double way, int *work)
{
    struct interval_slope_double rate[INTERVAL_RESULTS];
    struct interval_double state[2];
    struct box half[2];

    states_of(g, b, state);
    const bool whole =
        interval_over_double(g->plan, state, rate) == INTERVAL_WHOLE;
    const double lo = way * rate[1].value.lo, hi = way * rate[1].value.hi;
    if (whole && fmin(lo, hi) > 0.0)
        return true;
    if (--*work < 0 || (whole && fmax(lo, hi) <= 0.0))
        return false;
    halve(b, half);
    return crosses(g, half[0], way, work) && crosses(g, half[1], way, work);
}

/* The divergence of the field over the coordinates that are `taken`, times
 * these; false where formulas may have no values. */
static bool divergence(struct turning *g, struct box b, const bool taken[2],
                       struct interval_double *out)
{
    struct interval_slope_double rate[INTERVAL_RESULTS];
    struct interval_double state[2], part[2];

    states_of(g, b, state);
    if (interval_over_double(g->plan, state, rate) != INTERVAL_WHOLE)
        return false;
    for (int i = 0; i < 2; i++)
        part[i] = taken[i] ? interval_times_double(state[i], rate[2 + i].by[i])
                           : rate[i].by[i];
    *out = interval_add_double(part[0], part[1]);
    return !(taken[0] && state[0].lo <= 0.0 && state[0].hi >= 0.0) &&
           !(taken[1] && state[1].lo <= 0.0 && state[1].hi >= 0.0);
}

static bool falls(struct turning *g, struct box b, const bool taken[2],
                  int *work)
{
    const struct vec2 m = vec2_scale(0.5, vec2_add(b.lo, b.hi));
    struct interval_double d;
    struct box half[2];

    if (divergence(g, b, taken, &d) &&
        (g->backward ? d.lo >= 0.0 : d.hi <= 0.0))
        return true;
    if (--*work < 0 || !divergence(g, (struct box){ m, m }, taken, &d) ||
        (g->backward ? d.hi < 0.0 : d.lo > 0.0))
        return false;
    halve(b, half);
    return falls(g, half[0], taken, work) && falls(g, half[1], taken, work);
}

/* Whether there is no closed orbit in a box: with one of these divergences,
 * which is not 0 at its corner. */
static bool has_no_cycle(struct turning *g, struct box b)
{
    for (int k = 0; k < 4; k++) {
        const bool taken[] = { k % 2 == 1, k / 2 == 1 };
        int work = TOL_TURN_BOXES;
        struct interval_double d;
        if ((taken[0] && !g->shows[0]) || (taken[1] && !g->shows[1]))
            continue;
        if (divergence(g, (struct box){ b.lo, b.lo }, taken, &d) &&
            (g->backward ? d.lo > 0.0 : d.hi < 0.0) &&
            falls(g, b, taken, &work))
            return true;
    }
    return false;
}

/* ---- a turn -------------------------------------------------------------- */

static enum status add_corner(struct plane_turn *t, struct vec2 u)
{
    const enum status status = ROOM_FOR(t->at, t->room, t->corners + 1);

    if (status != STATUS_OK)
        return status;
    t->at[t->corners++] = u;
    t->box = box_around(t->box, u);
    return STATUS_OK;
}

static struct vec2 offset_at(const struct turning *g, const struct curve *c,
                             size_t piece, double theta)
{
    const struct vec2 side = g->s->scale.side;
    double at[CURVE_DIM_MAX];

    curve_at(c, piece, theta, at);
    return (struct vec2){ at[0] / side.x, at[1] / side.y };
}

/* Where the last piece comes to the row in the sense of the start, between lo
 * and hi. */
static double theta_of_row(const struct turning *g, const struct curve *c,
                           double sense, double lo, double hi)
{
    for (int i = 0; i < 52; i++) {
        const double middle = 0.5 * (lo + hi);
        *(sense * offset_at(g, c, c->count - 1, middle).y < 0.0 ? &lo : &hi) =
            middle;
    }
    return hi;
}

/* Corners on the last piece, up to where it comes to the row; *back: it does.
 */
static enum status add_piece(struct turning *g, const struct curve *c,
                             double sense, bool *back)
{
    enum { PARTS = 16 };
    struct plane_turn *t = g->turn;
    enum status status = STATUS_OK;

    for (int k = 1; k <= PARTS && status == STATUS_OK && !*back; k++) {
        const struct vec2 from = t->at[t->corners - 1];
        double last = (double) k / PARTS;
        struct vec2 u = offset_at(g, c, c->count - 1, last);
        *back = from.x > 0.0 && sense * from.y < 0.0 && sense * u.y >= 0.0;
        if (*back) {
            last = theta_of_row(g, c, sense, (k - 1.0) / PARTS, last);
            u = offset_at(g, c, c->count - 1, last);
        }
        const double middle = 0.5 * (last + (k - 1.0) / PARTS);
        t->off =
            fmax(t->off, 2.0 * distance(from, u,
                                        offset_at(g, c, c->count - 1, middle)));
        status = add_corner(t, u);
    }
    return status;
}

/* Twice the area, > 0 anticlockwise. */
static double area_of(const struct plane_turn *t)
{
    double sum = 0.0;

    for (size_t i = 0, k = t->corners - 1; i < t->corners; k = i++)
        sum += vec2_cross(t->at[k], t->at[i]);
    return sum;
}

/* The orbit from (size, 0) until it comes back to the row; *round: nearer, with
 * the focus inside and the part of the row between leading there. */
static enum status go_round(struct turning *g, double size, bool *round)
{
    const struct vec2 side = g->s->scale.side, start = { size, 0.0 };
    struct plane_turn *t = g->turn;
    struct planar_field f;
    const struct planar *system = &g->r->system[g->backward];
    struct taylor_orbit o =
        taylor_orbit_at(system, (struct vec2){ size * side.x, 0.0 }, side,
                        0.01 * TOL_RTOL_DEFAULT);
    bool back = false;
    int work = TOL_TURN_BOXES;

    *round = false;
    t->corners = 0;
    t->off = 0.0;
    t->box = (struct box){ start, start };
    system->field(system->ctx, (struct vec2){ size * side.x, 0.0 }, &f);
    const double sense = f.direction.y > 0.0 ? 1.0 : -1.0;
    enum status status = add_corner(t, start);
    while (status == STATUS_OK && !back && o.curve.count < TOL_TURN_STEPS) {
        status = taylor_orbit_step(&o);
        if (status == STATUS_OK)
            status = add_piece(g, &o.curve, sense, &back);
    }
    const double noise = TOL_ORBIT_RTOL * (double) (o.curve.count + 1);
    taylor_orbit_free(&o);
    if (status == STATUS_NO_MEMORY || !back)
        return status == STATUS_NO_MEMORY ? status : STATUS_OK;
    const struct vec2 end = t->at[t->corners - 1];
    t->off += noise;
    *round =
        end.x < size - 10.0 * noise && sense * area_of(t) > 0.0 &&
        is_inside(t, (struct vec2){ 0.0, 0.0 }, false) &&
        crosses(g,
                (struct box){ { end.x - noise, 0.0 }, { size + noise, 0.0 } },
                g->backward ? -sense : sense, &work);
    return STATUS_OK;
}

/* ---- whether it is a trap ------------------------------------------------ */

static struct box absolute(const struct turning *g, struct box b)
{
    const struct vec2 side = g->s->scale.side, z = g->z;

    return (struct box){ { z.x + b.lo.x * side.x, z.y + b.lo.y * side.y },
                         { z.x + b.hi.x * side.x, z.y + b.hi.y * side.y } };
}

/* Whether equilibria are none but the focus, *found being those of the box. */
static bool is_alone_among(const struct turning *g,
                           const struct system_equilibria *found)
{
    int inside = 0;

    for (int i = 0; i < found->count; i++) {
        const struct vec2 z = { (double) found->equilibrium[i].chart[0].value,
                                (double) found->equilibrium[i].chart[1].value };
        inside +=
            is_inside(g->turn, arrival_from(&g->s->scale, z, g->r->z), true);
    }
    return found->complete && inside == 1;
}

/* As is known of the window, or is found out about the box. */
static enum status look_alone(const struct turning *g, bool *alone)
{
    const struct plane_study *s = g->s;
    const double off = g->turn->off;
    const struct box b = g->turn->box,
                     all = absolute(
                         g, (struct box){ { b.lo.x - off, b.lo.y - off },
                                          { b.hi.x + off, b.hi.y + off } }),
                     w = plane_study_box(s);
    struct fault why;

    *alone =
        !(s->scale.period.x > 0.0 &&
          all.hi.x - all.lo.x >= s->scale.period.x) &&
        !(s->scale.period.y > 0.0 && all.hi.y - all.lo.y >= s->scale.period.y);
    for (size_t i = 0; i < s->rests && *alone; i++)
        *alone =
            &s->rest[i] == g->r ||
            !is_inside(g->turn, arrival_from(&s->scale, s->rest[i].z, g->r->z),
                       true);
    if (!*alone ||
        (s->complete && box_holds(w, all.lo) && box_holds(w, all.hi)))
        return STATUS_OK;
    struct system_equilibria *found = malloc(sizeof *found);
    if (found == NULL)
        return STATUS_NO_MEMORY;
    const struct system_window about = { { all.lo.x, all.lo.y },
                                         { all.hi.x, all.hi.y } };
    const enum status status =
        system_equilibria_find(s->scene->system, &about, found, &why);
    *alone = status == STATUS_OK && is_alone_among(g, found);
    free(found);
    return status == STATUS_NO_MEMORY ? status : STATUS_OK;
}

static enum status is_trap_at(struct turning *g, double size, bool *good)
{
    enum status status = go_round(g, size, good);

    if (status == STATUS_OK && *good)
        *good = has_no_cycle(g, g->turn->box);
    if (status == STATUS_OK && *good)
        status = look_alone(g, good);
    return status;
}

/* By halves, then, once it is one, by parts of a half. */
static enum status search(struct turning *g)
{
    const double least = fmax(g->r->trap[g->backward].size, TOL_SEEN);
    double size = 1.0, factor = 0.5;
    bool good = false;
    enum status status = STATUS_OK;

    while (!good && size > least && status == STATUS_OK) {
        status = is_trap_at(g, size, &good);
        size *= good ? 1.0 : factor;
    }
    while (factor * TOL_TURN_FACTOR < 1.0 && good && status == STATUS_OK) {
        bool larger;
        factor = sqrt(factor);
        status = is_trap_at(g, size / factor, &larger);
        size /= larger ? factor : 1.0;
    }
    if (good && status == STATUS_OK)
        status = is_trap_at(g, size, &good);
    if (!good || status != STATUS_OK)
        plane_turn_free(g->turn);
    return status;
}

/* ---- all ----------------------------------------------------------------- */

/* Formulas have rules: s->plan was made of them. */
static enum status plan_of(struct turning *g)
{
    const struct formula_system *f = g->s->scene->system;
    formula_real *value = calloc(FORMULA_NODES, sizeof *value);
    const int state[] = { f->state[0].node, f->state[1].node };
    int result[] = { f->rate[0], f->rate[1], f->rate[0], f->rate[1] }, left;
    struct fault why;
    enum status status = STATUS_NO_MEMORY;

    g->graph = malloc(sizeof *g->graph);
    g->plan = malloc(sizeof *g->plan);
    if (value && g->graph && g->plan) {
        *g->graph = f->graph;
        for (int i = 0; i < 2; i++) {
            g->shows[i] =
                formula_take_out(g->graph, f->rate[i], state[i], &left) &&
                !g->graph->full;
            result[2 + i] = g->shows[i] ? left : f->rate[i];
        }
        for (int i = 0; i < f->parameters; i++)
            value[f->parameter[i].node] = f->parameter[i].value;
        status =
            interval_plan(g->plan, g->graph, state, result, 4, value, &why);
    }
    free(value);
    return status;
}

/* Whether there may be one: its divergence falls next to the focus. */
static bool may_turn(struct turning *g)
{
    const struct box near = { { -TOL_SAME, -TOL_SAME },
                              { TOL_SAME, TOL_SAME } };

    return has_no_cycle(g, near);
}

enum status plane_turn_find(const struct plane_study *s, struct plane_rest *r)
{
    struct turning g = { .s = s, .r = r, .z = r->z };
    enum status status = STATUS_OK;

    if (!(r->lambda[0].im.value < 0.0))
        return STATUS_OK;
    status = plan_of(&g);
    for (int way = 0; way < 2 && status == STATUS_OK; way++) {
        g.backward = way == 1;
        g.turn = &r->turn[way];
        if (r->type != (way ? PLANE_STABLE_FOCUS : PLANE_UNSTABLE_FOCUS) &&
            may_turn(&g))
            status = search(&g);
    }
    free(g.graph);
    free(g.plan);
    return status == STATUS_NO_MEMORY ? status : STATUS_OK;
}

enum status plane_turn_forbids(const struct plane_study *s, struct box b,
                               bool *out)
{
    struct turning g = { .s = s, .z = b.lo };
    const struct vec2 d = vec2_sub(b.hi, b.lo), side = s->scale.side;
    const struct box all = { { 0.0, 0.0 }, { d.x / side.x, d.y / side.y } };
    const enum status status = plan_of(&g);

    *out = false;
    for (int way = 0; way < 2 && status == STATUS_OK && !*out; way++) {
        g.backward = way == 1;
        *out = has_no_cycle(&g, all);
    }
    free(g.graph);
    free(g.plan);
    return status == STATUS_NO_MEMORY ? status : STATUS_OK;
}
