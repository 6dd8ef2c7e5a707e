/* Regions of neighbouring bands that share a part of the row between them are
 * one: only whole patches are labelled, by the orbits from inside of their
 * largest regions. */
#include "plane_label.h"

#include <math.h>
#include <stdlib.h>

#include "plane_beyond.h"
#include "plane_border.h"
#include "plane_cycle.h"
#include "plane_mosaic.h"
#include "plane_orbit.h"
#include "study_tolerance.h"

/* ---- goals --------------------------------------------------------------- */

static size_t traps_before(const struct plane_study *s, size_t rest)
{
    size_t n = 0;

    for (size_t i = 0; i < rest; i++)
        n += s->rest[i].trap[0].size > 0.0;
    return n;
}

size_t plane_label_beyond(const struct plane_study *s)
{
    return traps_before(s, s->rests);
}

int8_t plane_label_of(const struct plane_study *s, const struct plane_goal *g)
{
    size_t n = plane_label_beyond(s);

    if (g->kind == PLANE_GOAL_REST)
        return (int8_t) traps_before(s, g->index);
    for (size_t i = 0; i < s->beyonds && g->kind == PLANE_GOAL_LEFT; i++)
        if (s->beyond[i].rests && !s->beyond[i].breaks &&
            !s->beyond[i].way[0] && !s->beyond[i].way[1])
            return (int8_t) (n + i);
    for (size_t i = 0; i < s->beyonds && g->kind == PLANE_GOAL_BEYOND; i++)
        if (plane_beyond_agree(s, &s->beyond[i], &g->beyond))
            return (int8_t) (n + i);
    if (g->kind != PLANE_GOAL_CYCLE || g->index >= s->cycles)
        return -1;
    n += s->beyonds;
    for (size_t k = 0; k < g->index; k++)
        n += s->cycle[k].type == PLANE_CYCLE_STABLE;
    return (int8_t) n;
}

/* Whether it is of something outside the window. */
static bool is_outside(const struct plane_study *s, int8_t label)
{
    size_t n = plane_label_beyond(s);

    if (label < 0 || (size_t) label < n + s->beyonds)
        return label >= 0 && (size_t) label >= n;
    n += s->beyonds;
    for (size_t k = 0; k < s->cycles; k++)
        if (s->cycle[k].type == PLANE_CYCLE_STABLE && n++ == (size_t) label)
            return !box_holds(s->window.box, s->cycle[k].round.at[0]);
    return false;
}

bool plane_label_allows(const struct plane_study *s, int8_t label,
                        const struct plane_goal *g)
{
    const size_t n = plane_label_beyond(s), i = (size_t) label - n;

    if (g->kind == PLANE_GOAL_LEFT)
        return is_outside(s, label);
    if (g->kind == PLANE_GOAL_BEYOND && label >= 0 && (size_t) label >= n &&
        i < s->beyonds)
        return plane_beyond_agree(s, &s->beyond[i], &g->beyond);
    return label == plane_label_of(s, g);
}

/* Whether both are one; *a then is what is known of it. */
static bool meet(const struct plane_study *s, struct plane_goal *a,
                 const struct plane_goal *b)
{
    if (a->kind == PLANE_GOAL_LEFT && b->kind == PLANE_GOAL_BEYOND)
        return true;
    if (a->kind == PLANE_GOAL_BEYOND && b->kind == PLANE_GOAL_LEFT)
        a->kind = PLANE_GOAL_LEFT;
    if (a->kind != b->kind)
        return false;
    if (a->kind != PLANE_GOAL_BEYOND)
        return a->index == b->index;
    if (a->beyond.rests != b->beyond.rests ||
        a->beyond.breaks != b->beyond.breaks)
        return false;
    plane_beyond_meet(s, &a->beyond, &b->beyond);
    return true;
}

/* ---- what is known so far ------------------------------------------------ */

/* Patches that have their goal, while others still get theirs. */
struct labelling {
    struct patches *p;
    struct plane_study *s;
    bool *done; /* by region, of patches */
    bool tiny;  /* the patch is so small that rounding makes closed orbits */
};

/* Orbits cross no border: whereto the patch goes that it has come to.  Not
 * where the border is too near to tell. */
static bool knows(void *ctx, struct vec2 z, struct plane_goal *out)
{
    const struct labelling *l = ctx;
    const struct regions *r = l->p->r;
    struct crossing *c = l->p->below;
    const size_t region = regions_at(r, z, c);
    const struct band *band = regions_band(r, z.y);
    const size_t k = region - band->first, patch = plane_patch_of(l->p, region);
    const double far = TOL_SAME * l->s->scale.side.x;

    if (!l->done[patch] || !box_holds(l->s->window.box, z) ||
        (k > 0 && !(z.x - c[k - 1].at > far + c[k - 1].error)) ||
        (k < band->strands && !(c[k].at - z.x > far + c[k].error)))
        return false;
    *out = l->p->goal[patch];
    return out->kind != PLANE_GOAL_NONE;
}

/* ---- witnesses ----------------------------------------------------------- */

static enum status follow(struct labelling *l, struct vec2 z, bool alone,
                          struct plane_goal *goal)
{
    const struct plane_guide guide = { .rounds = &l->s->rounds,
                                       .knows = alone ? NULL : knows,
                                       .ctx = l };
    enum status status = plane_orbit(l->s, z, false, &guide, goal);

    l->s->basin.steps += (int64_t) goal->steps;
    if (goal->kind == PLANE_GOAL_CYCLE && l->tiny &&
        goal->index == l->s->cycles)
        goal->kind = PLANE_GOAL_NONE;
    if (status == STATUS_OK && goal->kind == PLANE_GOAL_CYCLE)
        status = plane_cycle_add(l->s, &goal->round, true, &goal->index);
    if (goal->kind == PLANE_GOAL_CYCLE && goal->index == l->s->cycles) {
        goal->kind = PLANE_GOAL_NONE;
        l->s->basin.neutral++;
    }
    return status;
}

/* A region of a band, and rows of it. */
struct inside {
    const struct patches *p;
    const struct band *band;
    size_t k;
};

static struct inside region_of(const struct patches *p, size_t region)
{
    size_t i = 0;

    while (i + 1 < p->r->bands && p->r->band[i + 1].first <= region)
        i++;
    return (struct inside){ p, &p->r->band[i], region - p->r->band[i].first };
}

enum { ROWS = 16 };

/* How wide it is in the window on row i of some, and where; 0: nowhere. */
static double width_at(const struct inside *in, int i, double *y, double *lo)
{
    const struct patches *p = in->p;
    const struct box w = p->s->window.box;
    const double from = fmax(in->band->lo, w.lo.y),
                 to = fmin(in->band->hi, w.hi.y);

    *y = from + off_middle(i, i + 1) / ROWS * (to - from);
    const size_t n = separatrix_row(p->r->separatrix, *y, p->below);
    if (n != in->band->strands)
        return 0.0;
    *lo = plane_patch_end(p->s, p->below, n, in->k);
    return fmax(plane_patch_end(p->s, p->below, n, in->k + 1) - *lo, 0.0);
}

/* This far from the left to the right, on the row where it is widest; false: it
 * is nowhere wide. */
static bool place_in(const struct inside *in, double part, struct vec2 *z)
{
    double widest = 0.0, y, lo = 0.0;

    for (int i = 0; i < ROWS; i++) {
        const double width = width_at(in, i, &y, &lo);
        if (!(width > widest))
            continue;
        widest = width;
        *z = (struct vec2){ lo + part * width, y };
    }
    return widest > 0.0;
}

/* Whether orbits from all over the region go there: curves that are not known
 * may divide it, of what is outside the window. */
static enum status look_around(struct labelling *l, const struct inside *in,
                               struct plane_goal *goal)
{
    static const double part[] = { 0.03, 0.33, 0.67, 0.97 };
    enum status status = STATUS_OK;
    struct plane_goal other;
    double y, lo = 0.0;

    for (int i = 0; i < ROWS; i += 5)
        for (size_t j = 0; j < sizeof part / sizeof *part; j++) {
            const double width = width_at(in, i, &y, &lo);
            if (!(width > 0.0) || goal->kind == PLANE_GOAL_NONE)
                continue;
            status = follow(l, (struct vec2){ lo + part[j] * width, y }, true,
                            &other);
            if (status != STATUS_OK)
                return status;
            if (!meet(l->s, goal, &other))
                goal->kind = PLANE_GOAL_NONE;
        }
    return status;
}

/* Whereto the inside of a region goes; cycles that are new are added.  Of a
 * small one, where its orbit comes to another patch, whereto that goes. */
static enum status follow_region(struct labelling *l, size_t region, bool small,
                                 struct plane_goal *goal)
{
    const struct inside in = region_of(l->p, region);
    struct vec2 z;

    goal->kind = PLANE_GOAL_NONE;
    if (!place_in(&in, off_middle(0.0, 1.0), &z))
        return STATUS_OK;
    enum status status = follow(l, z, !small, goal);
    return status || small ? status : look_around(l, &in, goal);
}

/* ---- patches ------------------------------------------------------------- */

enum { WITNESSES = 3 };

/* The largest regions of a patch, by area, and the area of all. */
struct witnesses {
    size_t patch, count, region[WITNESSES];
    double area;
};

static void add_witness(const struct patches *p, struct witnesses *w, size_t i)
{
    size_t k = w->count < WITNESSES ? w->count++ : WITNESSES;

    w->area += p->area[i].value;
    for (; k > 0 && p->area[w->region[k - 1]].value < p->area[i].value; k--)
        if (k < WITNESSES)
            w->region[k] = w->region[k - 1];
    if (k < WITNESSES)
        w->region[k] = i;
}

static int by_area(const void *a, const void *b)
{
    const struct witnesses *p = a, *q = b;

    if (p->area != q->area)
        return p->area > q->area ? -1 : 1;
    return p->patch < q->patch ? -1 : p->patch > q->patch;
}

/* Whether the middles of all other regions go there, as far as these are large.
 */
static enum status look_on(struct labelling *l, const struct witnesses *w,
                           double least, struct plane_goal *goal)
{
    enum status status = STATUS_OK;
    struct plane_goal other;
    struct vec2 z;

    for (size_t i = 0; i < l->p->r->count && status == STATUS_OK; i++) {
        const struct inside in = region_of(l->p, i);
        bool seen = goal->kind == PLANE_GOAL_NONE ||
                    l->p->area[i].value < least ||
                    plane_patch_of(l->p, i) != w->patch;
        for (size_t k = 0; k < w->count; k++)
            seen = seen || w->region[k] == i;
        if (seen || !place_in(&in, off_middle(0.0, 1.0), &z))
            continue;
        status = follow(l, z, true, &other);
        if (status == STATUS_OK && !meet(l->s, goal, &other))
            goal->kind = PLANE_GOAL_NONE;
    }
    return status;
}

/* Of a patch, which is small if its area is less than the least. */
static enum status find_goal(struct labelling *l, const struct witnesses *w,
                             double least)
{
    const bool small = w->area < least;
    struct plane_goal *goal = &l->p->goal[w->patch], other;
    const size_t n = small && w->count > 1 ? 1 : w->count;
    enum status status = STATUS_OK;

    for (size_t k = 0; k < n && status == STATUS_OK; k++) {
        status = follow_region(l, w->region[k], small, k == 0 ? goal : &other);
        if (k > 0 && !meet(l->s, goal, &other))
            goal->kind = PLANE_GOAL_NONE;
    }
    if (status == STATUS_OK)
        status = look_on(l, w, least, goal);
    l->done[w->patch] = true;
    if (status == STATUS_OK && goal->kind == PLANE_GOAL_BEYOND)
        status = plane_beyond_add(l->s, &goal->beyond);
    return status;
}

static enum status ask(void *ctx, struct vec2 z, struct plane_goal *goal)
{
    return follow(ctx, z, false, goal);
}

/* The large regions of patches that are not of one goal. */
static enum status divide(struct labelling *l, const struct witnesses w[],
                          double all, const struct monitor *monitor)
{
    const struct patches *p = l->p;
    enum status status = STATUS_OK;

    l->tiny = false;
    for (size_t k = 0; k < p->r->count && w[k].area >= TOL_PLANE_LITTLE * all;
         k++)
        for (size_t i = 0; i < p->r->count && status == STATUS_OK; i++) {
            const double part = p->area[i].value / all;
            if (plane_patch_of(p, i) != w[k].patch || part < TOL_PLANE_LITTLE ||
                p->goal[w[k].patch].kind != PLANE_GOAL_NONE)
                continue;
            status = monitor_tell(monitor, "cells", i, p->r->count)
                         ? STATUS_STOPPED
                         : plane_mosaic_add(l->s, l->p, i, part, ask, l);
        }
    return status;
}

/* The large ones first, as long as work goes. */
static enum status find_goals(struct labelling *l, struct witnesses w[],
                              const struct monitor *monitor)
{
    const size_t n = l->p->r->count;
    enum status status = STATUS_OK;
    double all = 0.0;

    for (size_t i = 0; i < n; i++) {
        w[i].patch = i;
        if (l->p->area[i].value > 0.0)
            add_witness(l->p, &w[plane_patch_of(l->p, i)], i);
    }
    qsort(w, n, sizeof *w, by_area);
    for (size_t i = 0; i < n; i++)
        all += w[i].area;
    for (size_t i = 0; i < n && w[i].count > 0 && status == STATUS_OK &&
                       l->s->basin.steps < TOL_PLANE_WORK;
         i++) {
        l->tiny = w[i].area < TOL_SAME * all;
        status = monitor_tell(monitor, "regions", i, n)
                     ? STATUS_STOPPED
                     : find_goal(l, &w[i], TOL_PLANE_LITTLE * all);
    }
    return status ? status : divide(l, w, all, monitor);
}

enum status plane_label_all(struct plane_study *s, struct patches *p,
                            const struct monitor *monitor)
{
    struct witnesses *w = calloc(p->r->count + 1, sizeof *w);
    struct labelling l = { p, s, calloc(p->r->count + 1, sizeof *l.done),
                           false };
    enum status status = w && l.done ? STATUS_OK : STATUS_NO_MEMORY;

    plane_patch_join(p);
    if (status == STATUS_OK)
        status = find_goals(&l, w, monitor);
    if (status == STATUS_OK)
        status = plane_beyond_finish(s);
    for (size_t i = 0; i < p->r->count && status == STATUS_OK; i++) {
        const int8_t label = plane_label_of(s, &p->goal[plane_patch_of(p, i)]);
        p->r->region[i].label = label < 0 ? REGION_UNLABELLED : label;
    }
    if (status == STATUS_OK)
        plane_mosaic_name(s);
    free(w);
    free(l.done);
    return status;
}
