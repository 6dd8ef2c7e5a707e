/* All curves are moved to one origin; of an angle, there is one copy for each
 * period in which a curve meets the window.  Of each copy only runs of pieces
 * that may touch the window are kept: beyond it nothing is divided, and a
 * spiral goes round for ever. */
#include "plane_border.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "escape.h"
#include "plane_cycle.h"
#include "plane_orbit.h"
#include "plane_rest.h"
#include "plane_tolerance.h"
#include "room.h"
#include "taylor_orbit.h"
#include "tolerance.h"

/* ---- cycles that repel --------------------------------------------------- */

enum status plane_border_look_from(struct plane_study *s, struct vec2 z)
{
    struct plane_goal goal;
    size_t index;
    enum status status = plane_orbit(s, z, true, NULL, &goal);

    if (status == STATUS_OK && goal.kind == PLANE_GOAL_CYCLE)
        status = plane_cycle_add(s, &goal.round, false, &index);
    return status;
}

/* On either side of a return. */
static enum status look_beside(struct plane_study *s, const struct winding *w)
{
    const struct vec2 side = vec2_scale(TOL_SEEN, s->scale.side);
    const bool across = w->section == WINDING_ROUND_Y;
    const struct vec2 d = { across ? side.x : 0.0, across ? 0.0 : side.y };
    const enum status status = plane_border_look_from(s, vec2_add(w->at[0], d));

    return status ? status : plane_border_look_from(s, vec2_sub(w->at[0], d));
}

/* Within its trap, and as far out in that as a turn tells. */
static struct vec2 inside(const struct plane_study *s,
                          const struct plane_rest *r)
{
    const double far =
        r->turn[0].corners ? r->turn[0].at[0].x : 0.1 * r->trap[0].size;

    return vec2_add(r->z, (struct vec2){ far * s->scale.side.x, 0.0 });
}

enum status plane_border_look(struct plane_study *s, size_t rests,
                              size_t cycles)
{
    enum status status = STATUS_OK;

    for (size_t i = rests; i < s->rests && status == STATUS_OK; i++)
        if (plane_rest_attracts(&s->rest[i], false))
            status = plane_border_look_from(s, inside(s, &s->rest[i]));
    for (size_t k = cycles; k < s->cycles && status == STATUS_OK; k++)
        if (s->cycle[k].type == PLANE_CYCLE_STABLE)
            status = look_beside(s, &s->cycle[k].round);
    return status;
}

/* ---- curves -------------------------------------------------------------- */

/* Curves of offsets, how far they are moved, what they are off everywhere
 * besides, and what they belong to. */
struct moved {
    struct vec2 by; /* to offsets from the study's origin */
    double error;
    size_t of;
};

/* Pieces first .. last - 1. */
static enum status copy(const struct curve *from, size_t first, size_t last,
                        const struct moved *m, struct branch *out)
{
    enum status status = STATUS_OK;

    *out = (struct branch){ .curve = CURVE_EMPTY(2), .end = BRANCH_DOMAIN };
    for (size_t i = first; i < last && status == STATUS_OK; i++) {
        const struct curve_piece *p = &from->piece[i];
        double *coef;
        status = curve_push(&out->curve, p->degree, &coef);
        if (status != STATUS_OK)
            break;
        memcpy(coef, from->coef + p->first, 2 * (p->degree + 1) * sizeof *coef);
        coef[0] += m->by.x;
        coef[p->degree + 1] += m->by.y;
        out->curve.piece[i - first].error = p->error + m->error;
    }
    return status;
}

/* Both halves of a chain, from a piece on. */
struct chain {
    const struct curve *c[2]; /* borrowed; or NULL */
    struct box *around[2];    /* owned; of its pieces: escape_around */
    struct box all;
    size_t first;
};

static enum status chain_begin(const struct plane_study *s, struct chain *h)
{
    const struct vec2 size = vec2_sub(s->window.box.hi, s->window.box.lo);

    h->all = BOX_NOTHING;
    for (int k = 0; k < 2; k++) {
        const size_t n = h->c[k] ? h->c[k]->count : 0;
        h->around[k] = calloc(n + 1, sizeof *h->around[k]);
        if (h->around[k] == NULL)
            return STATUS_NO_MEMORY;
        for (size_t i = 0; i < n; i++) {
            const struct box b = escape_around(h->c[k], i, size);
            h->around[k][i] = b;
            h->all = box_around(box_around(h->all, b.lo), b.hi);
        }
    }
    return STATUS_OK;
}

/* How many periods a coordinate between lo and hi may be moved and still meet
 * the window's: from, to. */
static void periods(double lo, double hi, double from, double to, double period,
                    int turn[2])
{
    turn[0] = turn[1] = 0;
    if (!(period > 0.0) || !(lo <= hi))
        return;
    turn[0] = (int) fmax(ceil((from - hi) / period), -TOL_PLANE_TURNS);
    turn[1] = (int) fmin(floor((to - lo) / period), TOL_PLANE_TURNS);
}

/* The pieces of half k from `first` on that may touch the window: up to which.
 */
static size_t run_from(const struct plane_study *s, const struct chain *h,
                       int k, size_t first, const struct moved *m)
{
    const struct vec2 origin = vec2_add(s->system[0].origin, m->by);
    const struct box w = box_from(s->window.box, origin);

    while (h->c[k] && first < h->c[k]->count &&
           box_meets(w, h->around[k][first]) &&
           escape_may_touch(h->c[k], first, origin, s->window.box))
        first++;
    return first;
}

static enum status new_border(struct plane_study *s, size_t of, int way,
                              struct plane_border **out)
{
    struct plane_basin *b = &s->basin;
    const enum status status =
        ROOM_FOR(b->border, b->border_room, b->borders + 1);

    if (status != STATUS_OK)
        return status;
    *out = &b->border[b->borders++];
    **out = (struct plane_border){ .of = of, .way = way };
    for (int k = 0; k < 2; k++)
        (*out)->half[k].curve = CURVE_EMPTY(2);
    return STATUS_OK;
}

/* The runs of half k from a piece on. */
static enum status add_runs(struct plane_study *s, const struct chain *h, int k,
                            size_t first, const struct moved *m)
{
    const size_t n = h->c[k] ? h->c[k]->count : 0;
    struct plane_border *new;
    enum status status = STATUS_OK;

    for (size_t i = first; i < n && status == STATUS_OK; i++) {
        const size_t last = run_from(s, h, k, i, m);
        if (last == i)
            continue;
        status = new_border(s, m->of, k ? 1 : -1, &new);
        if (status == STATUS_OK)
            status = copy(h->c[k], i, last, m, &new->half[1]);
        i = last;
    }
    return status;
}

/* The run through the place where both begin, and the others. */
static enum status add_copy(struct plane_study *s, const struct chain *h,
                            const struct moved *m)
{
    const size_t last[] = { run_from(s, h, 0, h->first, m),
                            run_from(s, h, 1, h->first, m) };
    struct plane_border *new = NULL;
    enum status status = STATUS_OK;

    if (last[0] > h->first || last[1] > h->first)
        status = new_border(s, m->of, 1, &new);
    for (int k = 0; k < 2 && new &&status == STATUS_OK; k++)
        if (last[k] > h->first)
            status = copy(h->c[k], h->first, last[k], m, &new->half[k]);
    for (int k = 0; k < 2 && status == STATUS_OK; k++)
        status = add_runs(s, h, k, last[k], m);
    return status;
}

/* A chain about an origin, off by an error besides, and its copies. */
static enum status add(struct plane_study *s, struct chain h,
                       struct vec2 origin, double error, size_t of)
{
    const struct vec2 period = s->scale.period;
    const struct box w = box_from(s->window.box, origin);
    int x[2], y[2];
    enum status status = chain_begin(s, &h);

    periods(h.all.lo.x, h.all.hi.x, w.lo.x, w.hi.x, period.x, x);
    periods(h.all.lo.y, h.all.hi.y, w.lo.y, w.hi.y, period.y, y);
    for (int i = x[0]; i <= x[1]; i++)
        for (int j = y[0]; j <= y[1] && status == STATUS_OK; j++) {
            const struct vec2 way = { i * period.x, j * period.y };
            const struct moved m = {
                vec2_add(vec2_sub(origin, s->system[0].origin), way), error, of
            };
            status = add_copy(s, &h, &m);
        }
    free(h.around[0]);
    free(h.around[1]);
    return status;
}

static double height(const struct curve *c, size_t piece, double theta)
{
    double at[CURVE_DIM_MAX];

    curve_at(c, piece, theta, at);
    return at[1];
}

/* From the top of a round to half of its height: ends of a curve that lie at
 * its top are in no band that is wide.  *first: the piece where that is now;
 * the orbit goes on to the same place, where y has a period up to that, and by
 * a piece more. */
static enum status go_down(struct taylor_orbit *o, double period, size_t *first,
                           size_t last)
{
    double top = -HUGE_VAL, bottom = HUGE_VAL;
    enum status status = STATUS_OK;

    for (size_t i = *first; i <= last; i++) {
        top = fmax(top, height(&o->curve, i, 0.0));
        bottom = fmin(bottom, height(&o->curve, i, 0.0));
    }
    const double middle = 0.5 * (top + bottom),
                 way = height(&o->curve, last, 0.0) -
                       height(&o->curve, *first, 0.0),
                 round = period > 0.0 ? period * rint(way / period) : 0.0;
    while (*first < last && height(&o->curve, *first, 0.0) > middle)
        ++*first;
    for (bool more = true; more && status == STATUS_OK; last++) {
        more = height(&o->curve, last, 1.0) > middle + round &&
               last < TOL_CURVE_STEPS;
        if (last + 1 == o->curve.count)
            status = taylor_orbit_step(o);
        if (last + 1 == o->curve.count)
            break;
    }
    o->curve.count = last + 1;
    return status;
}

/* The last of some rounds backward in time, until they repeat to rounding or
 * come no nearer to each other. */
static enum status add_cycle(struct plane_study *s, size_t k)
{
    const struct planar *system = &s->system[1];
    const struct winding *w = &s->cycle[k].round;
    struct winding round = winding_from(w, &s->scale);
    struct taylor_orbit o =
        taylor_orbit_at(system, vec2_sub(w->at[0], system->origin),
                        s->scale.side, 0.01 * TOL_RTOL_DEFAULT);
    size_t first = 0, last = 0, before = 0;
    double gap = HUGE_VAL, next = HUGE_VAL, ratio = 0.0;

    enum status status = STATUS_OK;
    while (o.curve.count < TOL_CURVE_STEPS) {
        status = taylor_orbit_step(&o);
        if (status != STATUS_OK)
            break;
        before = round.count;
        (void) winding_add(&round, system, &s->scale, &o.curve,
                           o.curve.count - 1, NULL, 0);
        if (round.count == before || round.count % w->turns != 0)
            continue;
        first = last;
        last = o.curve.count - 1;
        if (round.count <= w->turns)
            continue;
        next = vec2_length(
            arrival_from(&s->scale, round.at[0], round.at[w->turns]));
        if (next <= TOL_ROUNDED || next > TOL_WINDING_SHRINK * gap)
            break;
        ratio = next / gap;
        gap = next;
    }
    gap = fmin(gap, next);
    if (status == STATUS_OK && gap < HUGE_VAL && first > 0 &&
        w->section == WINDING_HIGHEST)
        status = go_down(&o, s->scale.period.y, &first, last);
    if (status != STATUS_NO_MEMORY && gap < HUGE_VAL && first > 0) {
        const struct chain h = { .c = { NULL, &o.curve }, .first = first };
        status = add(s, h, system->origin,
                     10.0 * gap / (1.0 - ratio) *
                             fmax(s->scale.side.x, s->scale.side.y) +
                         TOL_RTOL_DEFAULT * vec2_length(s->scale.side),
                     s->branches + k);
    }
    taylor_orbit_free(&o);
    return status == STATUS_NO_MEMORY ? status : STATUS_OK;
}

static enum status cut(struct plane_study *s)
{
    struct plane_basin *b = &s->basin;
    enum status status = STATUS_OK;

    b->cuts = separatrix_empty(SEPARATRIX_Y, s->system[0].origin);
    b->columns = separatrix_empty(SEPARATRIX_X, s->system[0].origin);
    for (size_t i = 0; i < b->borders && status == STATUS_OK; i++) {
        struct plane_border *p = &b->border[i];
        const struct branch *half[2];
        for (int k = 0; k < 2; k++)
            half[k] = p->half[k].curve.count ? &p->half[k] : NULL;
        p->first = b->cuts.count;
        status = separatrix_add(&b->cuts, half[0], half[1]);
        p->last = b->cuts.count;
        if (status == STATUS_OK)
            status = separatrix_add(&b->columns, half[0], half[1]);
    }
    return status;
}

/* Whether something may neither attract nor repel, or both: around a centre
 * orbits are held in by unstable manifolds, too, which are borders then, and
 * half of what is next to a fold goes there. */
static bool is_weak(const struct plane_study *s)
{
    bool weak = !s->complete || s->broken;

    for (size_t i = 0; i < s->rests; i++)
        weak = weak || s->rest[i].type == PLANE_NONHYPERBOLIC;
    return weak;
}

/* A stable manifold is one chain; an unstable one, which crosses that at the
 * saddle, two, which end there: the order of chains along rows changes only at
 * their ends. */
static enum status add_manifold(struct plane_study *s, size_t of)
{
    const struct plane_branch *b = &s->branch[of];
    const struct plane_rest *r = &s->rest[b->rest];
    const struct chain both = { .c = { &b[0].curve.curve, &b[1].curve.curve } },
                       one = { .c = { both.c[0], NULL } },
                       other = { .c = { NULL, both.c[1] } };
    const double error = vec2_length(r->error);

    if (b->kind == MANIFOLD_STABLE)
        return add(s, both, r->z, error, of);
    const enum status status = add(s, one, r->z, error, of);
    return status ? status : add(s, other, r->z, error, of);
}

enum status plane_border_find(struct plane_study *s)
{
    const bool all = is_weak(s);
    enum status status = STATUS_OK;

    for (size_t i = 0; i + 1 < s->branches && status == STATUS_OK; i++)
        if (s->branch[i].branch == 0 &&
            (s->branch[i].kind == MANIFOLD_STABLE || all))
            status = add_manifold(s, i);
    for (size_t k = 0; k < s->cycles && status == STATUS_OK; k++)
        if (s->cycle[k].type == PLANE_CYCLE_UNSTABLE)
            status = add_cycle(s, k);
    return status ? status : cut(s);
}
