/* Regions of neighbouring bands that share a part of the row between them are
 * one: only whole patches are labelled, by the orbits from inside of their
 * largest regions. */
#include "plane_label.h"

#include <stdlib.h>

#include "plane_beyond.h"
#include "plane_cycle.h"
#include "plane_edge.h"
#include "plane_mosaic.h"
#include "plane_orbit.h"
#include "plane_parts.h"
#include "plane_rest.h"
#include "plane_side.h"
#include "plane_tolerance.h"

/* ---- curves that divide -------------------------------------------------- */

static size_t borders_of(const struct plane_study *s)
{
    size_t n = 0;

    for (size_t i = 0; i < s->rests; i++)
        n += s->rest[i].type == PLANE_SADDLE;
    for (size_t k = 0; k < s->cycles; k++)
        n += s->cycle[k].type == PLANE_CYCLE_UNSTABLE;
    return n;
}

/* ---- what is known so far ------------------------------------------------ */

/* Patches that have their goal, while others still get theirs. */
struct labelling {
    struct patches *p;
    struct plane_study *s;
    const struct monitor *monitor; /* borrowed; or NULL */
    uint64_t orbits;               /* of which it was told */
    bool *done, *seen; /* by region, of patches: asked once; and once more */
    enum plane_side *told; /* by region, of patches */
    struct vec2 *at;       /* where the orbit began that told their goal */
    struct plane_parts parts;
    bool tiny;    /* the patch is so small that rounding makes closed orbits */
    int edges;    /* looked for in this window */
    size_t known; /* curves that are borders, when it began */
};

/* The patch that an absolute point is in, if no border is too near to tell. */
static bool patch_at(const struct labelling *l, struct vec2 z, size_t *patch)
{
    const struct regions *r = l->p->r;
    struct crossing *c = l->p->below;
    const size_t region = regions_at(r, z, c);
    const struct band *band = regions_band(r, z.y);
    const size_t k = region - band->first;
    const double far = TOL_SAME * l->s->scale.side.x;

    *patch = plane_patch_of(l->p, region);
    return l->done[*patch] && box_holds(l->s->window.box, z) &&
           !(k > 0 && !(z.x - c[k - 1].at > far + c[k - 1].error)) &&
           !(k < band->strands && !(c[k].at - z.x > far + c[k].error));
}

/* Orbits cross no border: whereto the patch goes that it has come to. */
static bool knows(void *ctx, struct vec2 z, struct plane_goal *out)
{
    const struct labelling *l = ctx;
    size_t patch;

    l->s->basin.steps += plane_patch_work(l->p, 1);
    if (!patch_at(l, z, &patch) || l->parts.several[patch])
        return false;
    *out = l->p->goal[patch];
    return out->kind != PLANE_GOAL_NONE;
}

static bool has_news(const struct labelling *l)
{
    return borders_of(l->s) > l->known;
}

/* ---- witnesses ----------------------------------------------------------- */

/* An equilibrium outside the window, by its number. */
static enum status know_rest(struct plane_study *s, struct plane_goal *goal)
{
    const struct plane_beyond *b = &goal->beyond;
    size_t rest;

    if (goal->kind != PLANE_GOAL_BEYOND || !b->rests || b->breaks ||
        b->way[0] != PLANE_WAY_LIMIT || b->way[1] != PLANE_WAY_LIMIT)
        return STATUS_OK;
    const enum status status =
        plane_rest_add(s, (struct vec2){ b->limit[0], b->limit[1] }, &rest);
    if (status == STATUS_OK && rest < s->rests &&
        plane_rest_attracts(&s->rest[rest], false)) {
        goal->kind = PLANE_GOAL_REST;
        goal->index = rest;
    }
    return status;
}

/* Of an orbit that came round and round and to no end: the equilibrium outside
 * the window that Newton's steps find from there, if it is in its trap; not
 * where there are so many that no orbit tells of more than its own strip. */
static enum status know_trap(struct plane_study *s, struct plane_goal *goal)
{
    size_t rest;

    if (goal->kind != PLANE_GOAL_NONE || goal->round.count == 0 ||
        s->rests > s->listed + TOL_PLANE_STRIPS)
        return STATUS_OK;
    const enum status status = plane_rest_add(s, goal->round.at[0], &rest);
    if (status == STATUS_OK && rest < s->rests &&
        plane_rest_traps(s, &s->rest[rest], false, goal->round.at[0])) {
        goal->kind = PLANE_GOAL_REST;
        goal->index = rest;
    }
    return status;
}

/* Counts the steps of an orbit and names its goal: equilibria and cycles that
 * are new are added. */
static enum status take(struct labelling *l, struct plane_goal *goal)
{
    enum status status = know_rest(l->s, goal);

    l->s->basin.steps += (int64_t) goal->steps;
    if (status == STATUS_OK && goal->kind == PLANE_GOAL_CYCLE && !l->tiny)
        status = plane_cycle_add(l->s, &goal->round, true, &goal->index);
    const bool none =
        goal->kind == PLANE_GOAL_CYCLE && goal->index == l->s->cycles;
    if (none) {
        goal->kind = PLANE_GOAL_NONE;
        goal->why = PLANE_UNKNOWN_CLOSED;
    }
    if (status == STATUS_OK)
        status = know_trap(l->s, goal);
    if (goal->kind == PLANE_GOAL_NONE) {
        l->s->basin.unknown[goal->why] = true;
        l->s->basin.neutral += none && !l->tiny;
    }
    return status;
}

/* Asked before each orbit, by any thread. */
static bool is_stopped(struct labelling *l)
{
    bool stopped;

#pragma omp critical
    stopped = monitor_tell(l->monitor, "regions", l->orbits++, 0) != 0;
    return stopped;
}

static enum status follow(struct labelling *l, struct vec2 z, bool alone,
                          struct plane_goal *goal)
{
    const struct plane_guide guide = { .rounds = &l->s->rounds,
                                       .knows = alone ? NULL : knows,
                                       .ctx = l };
    const enum status status = is_stopped(l)
                                   ? STATUS_STOPPED
                                   : plane_orbit(l->s, z, false, &guide, goal);

    return status ? status : take(l, goal);
}

static enum status ask(void *ctx, struct vec2 z, struct plane_goal *goal)
{
    return follow(ctx, z, false, goal);
}

static enum status ask_alone(void *ctx, struct vec2 z, struct plane_goal *goal)
{
    return follow(ctx, z, true, goal);
}

/* ---- patches ------------------------------------------------------------- */

/* By an orbit from its inside; of a small patch, where that comes to another
 * patch, whereto that goes. */
static enum status find_goal(struct labelling *l, const struct patch_whole *w,
                             bool small)
{
    struct plane_goal *goal = &l->p->goal[w->patch];
    struct vec2 *z = &l->at[w->patch];
    enum status status = STATUS_OK;

    l->seen[w->patch] = l->told[w->patch] == PLANE_SIDE_TOLD;
    if (l->told[w->patch] == PLANE_SIDE_NONE && !l->p->alone[w->patch] &&
        plane_patch_place(l->p, w->largest, z))
        status = follow(l, *z, !small, goal);
    l->done[w->patch] = true;
    return status;
}

/* ---- all over the window ------------------------------------------------- */

enum { LOOKS = 32 };

/* One state more of a patch: what it has in common with the others; if that is
 * less, what divides them is looked for. */
static enum status compare(struct labelling *l, size_t patch, struct vec2 z,
                           const struct plane_goal *goal)
{
    enum { EDGES = 3 };
    struct plane_goal *own = &l->p->goal[patch];
    struct plane_edge e = { { l->at[patch], z }, { *own, *goal } };
    const bool both =
        own->kind != PLANE_GOAL_NONE && goal->kind != PLANE_GOAL_NONE;

    const bool one = plane_goal_meet(l->s, own, goal);
    const bool less = own->beyond.way[0] != e.goal[0].beyond.way[0] ||
                      own->beyond.way[1] != e.goal[0].beyond.way[1];
    if (!one)
        own->kind = PLANE_GOAL_NONE;
    return both && (!one || less) && !l->parts.several[patch] &&
                   l->edges++ < EDGES
               ? plane_edge_find(l->s, &e, ask_alone, l)
               : STATUS_OK;
}

/* Orbits from more states, which those of their patches must go along with. */
static enum status look_from(struct labelling *l, const struct vec2 z[],
                             size_t n)
{
    struct plane_goal goal[LOOKS];
    size_t patch[LOOKS];
    bool known[LOOKS], stopped = false, failed = false;
    enum status status = STATUS_OK;

    for (size_t i = 0; i < n; i++)
        known[i] = patch_at(l, z[i], &patch[i]) &&
                   l->p->goal[patch[i]].kind != PLANE_GOAL_NONE;
#pragma omp parallel for schedule(dynamic, 1) reduction(|| : failed, stopped)
    for (size_t i = 0; i < n; i++) {
        stopped = stopped || is_stopped(l);
        failed = failed ||
                 (known[i] && !stopped &&
                  plane_orbit(l->s, z[i], false, NULL, &goal[i]) != STATUS_OK);
    }
    if (failed || stopped)
        return failed ? STATUS_NO_MEMORY : STATUS_STOPPED;
    for (size_t i = 0; i < n && status == STATUS_OK; i++) {
        if (!known[i])
            continue;
        l->seen[patch[i]] = true;
        status = take(l, &goal[i]);
        if (status == STATUS_OK)
            status = compare(l, patch[i], z[i], &goal[i]);
    }
    return status;
}

/* Whether work for labels is left; that it is not is a reason. */
static bool has_work(struct labelling *l)
{
    const bool work = l->s->basin.steps < TOL_PLANE_WORK;

    l->s->basin.unknown[PLANE_UNKNOWN_WORK] |= !work;
    return work;
}

/* Every part (plane_parts.h) of a patch that has several; no orbit speaks for
 * such patches where work does not go so far. */
static enum status look_at_parts(struct labelling *l)
{
    const size_t cells = l->parts.n * l->parts.n;
    enum status status = STATUS_OK;
    struct vec2 z[LOOKS];
    size_t count = 0;

    for (size_t i = 0;
         i < cells && status == STATUS_OK && !has_news(l) && has_work(l); i++) {
        count += plane_parts_place(&l->parts, l->s, i, &z[count]);
        if (count < LOOKS && i + 1 < cells)
            continue;
        status = look_from(l, z, count);
        count = 0;
    }
    for (size_t k = 0; k < l->p->r->count && cells > 0 && !has_work(l); k++)
        if (l->parts.several[k])
            l->p->goal[k].kind = PLANE_GOAL_NONE;
    return status;
}

/* Number i of the places that are looked at: the middle of a large region, what
 * attracts, one of those spread over the window; false: it is none. */
static bool place_at(const struct labelling *l, size_t i, double least,
                     struct vec2 *z)
{
    const struct plane_study *s = l->s;
    const size_t regions = l->p->r->count;

    if (i < regions)
        return l->p->area[i].value >= least && plane_patch_place(l->p, i, z);
    i -= regions;
    if (i < s->listed) {
        *z = s->rest[i].z;
        return plane_rest_attracts(&s->rest[i], false);
    }
    *z = window_at(&s->window, vec2_spread(0.25, (double) (i - s->listed)));
    return true;
}

/* All of these, until there is a curve that divides more. */
static enum status look_over(struct labelling *l, double least)
{
    const size_t n = l->p->r->count + l->s->listed + TOL_PLANE_LOOKS;
    enum status status = STATUS_OK;
    struct vec2 z[LOOKS];
    size_t count = 0;

    for (size_t i = 0;
         i < n && status == STATUS_OK && !has_news(l) && has_work(l); i++) {
        count += place_at(l, i, least, &z[count]);
        if (count < LOOKS && i + 1 < n)
            continue;
        status = look_from(l, z, count);
        count = 0;
    }
    return status;
}

/* Whether a region, which is `part` of the window, is of a patch that is not of
 * one goal, and large; not where a manifold that winds on was given up in it,
 * between whose turns no cell would tell one side from the other. */
static bool is_open(const struct labelling *l, size_t region, double part)
{
    const size_t patch = plane_patch_of(l->p, region);

    return part >= TOL_SEEN && l->p->area[region].value > 0.0 &&
           l->p->goal[patch].kind == PLANE_GOAL_NONE &&
           !(l->told[patch] == PLANE_SIDE_DIFFER &&
             l->s->basin.unknown[PLANE_UNKNOWN_BORDER]);
}

/* Those regions, with work by their areas. */
static enum status divide(struct labelling *l, double all)
{
    const struct patches *p = l->p;
    enum status status = STATUS_OK;
    double left = 0.0;

    for (size_t i = 0; i < p->r->count; i++)
        left += is_open(l, i, p->area[i].value / all) ? p->area[i].value : 0.0;
    l->s->basin.steps = 0;
    for (size_t i = 0; i < p->r->count && status == STATUS_OK; i++) {
        const double area = p->area[i].value;
        const int64_t done = l->s->basin.steps,
                      more = (int64_t) ((double) (TOL_PLANE_WORK - done) *
                                        area / left);
        if (!is_open(l, i, area / all))
            continue;
        status = plane_mosaic_add(l->s, l->p, &l->parts, i, area / all,
                                  done + more, ask, l);
        left -= area;
    }
    return status;
}

/* The patches from *next on with so large an area, as long as work goes. */
static enum status find_goals_of(struct labelling *l,
                                 const struct patch_whole w[], size_t *next,
                                 double area, double least)
{
    enum status status = STATUS_OK;

    for (; *next < l->p->r->count && w[*next].area > area &&
           status == STATUS_OK && has_work(l);
         ++*next)
        status = find_goal(l, &w[*next], w[*next].area < least);
    return status;
}

/* The large ones first; the tiny ones if no border is new and work is left. */
static enum status find_goals(struct labelling *l, struct patch_whole w[])
{
    const double all = plane_patch_sort(l->p, w), least = TOL_SEEN * all;
    size_t next = 0;
    enum status status =
        plane_side_find(l->s, l->p, ask_alone, l, l->told, l->at);

    if (status == STATUS_OK)
        status = find_goals_of(l, w, &next, TOL_SAME * all, least);
    const bool all_large = has_work(l);

    l->s->basin.steps = 0;
    if (status == STATUS_OK)
        status = look_at_parts(l);
    if (status == STATUS_OK)
        status = look_over(l, least);
    for (size_t k = 0; k < l->p->r->count && w[k].area >= least && !has_work(l);
         k++)
        if (!l->seen[w[k].patch]) /* one orbit's goal is not all of its */
            l->p->goal[w[k].patch].kind = PLANE_GOAL_NONE;
    l->tiny = true;
    l->s->basin.steps = 0;
    if (status == STATUS_OK && !has_news(l) && all_large)
        status = find_goals_of(l, w, &next, 0.0, least);
    l->tiny = false;
    if (status == STATUS_OK && !has_news(l))
        status = divide(l, all);
    for (size_t i = 0; i < l->p->r->count && status == STATUS_OK; i++)
        if (l->p->goal[i].kind == PLANE_GOAL_BEYOND)
            status = plane_beyond_add(l->s, &l->p->goal[i].beyond);
    return status;
}

enum status plane_label_all(struct plane_study *s, struct patches *p,
                            const struct monitor *monitor, bool *news)
{
    const size_t n = p->r->count + 1;
    struct patch_whole *w = calloc(n, sizeof *w);
    struct labelling l = { .p = p,
                           .s = s,
                           .monitor = monitor,
                           .done = calloc(n, sizeof *l.done),
                           .seen = calloc(n, sizeof *l.seen),
                           .told = calloc(n, sizeof *l.told),
                           .at = calloc(n, sizeof *l.at),
                           .known = borders_of(s) };
    enum status status =
        w && l.done && l.seen && l.told && l.at ? STATUS_OK : STATUS_NO_MEMORY;

    if (status == STATUS_OK)
        status = plane_patch_join(p);
    if (status == STATUS_OK)
        status = plane_parts_find(p, &l.parts);
    if (status == STATUS_OK)
        status = find_goals(&l, w);
    *news = has_news(&l);
    if (status == STATUS_OK)
        status = plane_beyond_finish(s);
    for (size_t i = 0; i < p->r->count && status == STATUS_OK; i++) {
        const int8_t label =
            plane_goal_label(s, &p->goal[plane_patch_of(p, i)]);
        p->r->region[i].label = label < 0 ? REGION_UNLABELLED : label;
    }
    if (status == STATUS_OK)
        plane_mosaic_name(s);
    free(w);
    free(l.done);
    free(l.seen);
    free(l.told);
    free(l.at);
    plane_parts_free(&l.parts);
    return status;
}
