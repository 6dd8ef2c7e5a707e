/* Regions of neighbouring bands that share a part of the row between them are
 * one: only whole patches are labelled, by the orbits from inside of their
 * largest regions. */
#include "plane_label.h"

#include <math.h>

#include "plane_beyond.h"
#include "plane_border.h"
#include "plane_branch.h"
#include "plane_cycle.h"

double plane_label_between(double lo, double hi)
{
    return lo + 0.4871 * (hi - lo);
}

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

bool plane_label_allows(const struct plane_study *s, int8_t label,
                        const struct plane_goal *g)
{
    const size_t n = plane_label_beyond(s), i = (size_t) label - n;

    if (g->kind == PLANE_GOAL_BEYOND && label >= 0 && (size_t) label >= n &&
        i < s->beyonds)
        return plane_beyond_agree(s, &s->beyond[i], &g->beyond);
    return label == plane_label_of(s, g);
}

/* Whether both are one; *a then is what is known of it. */
static bool meet(const struct plane_study *s, struct plane_goal *a,
                 const struct plane_goal *b)
{
    if (a->kind != b->kind)
        return false;
    if (a->kind != PLANE_GOAL_BEYOND)
        return a->index == b->index;
    if (a->beyond.rests != b->beyond.rests)
        return false;
    plane_beyond_meet(s, &a->beyond, &b->beyond);
    return true;
}

/* ---- witnesses ----------------------------------------------------------- */

static enum status follow(struct plane_study *s, struct vec2 z,
                          struct plane_goal *goal)
{
    enum status status = plane_follow(s, z, false, goal);

    if (status == STATUS_OK && goal->kind == PLANE_GOAL_CYCLE)
        status = plane_cycle_add(s, &goal->round, true, &goal->index);
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

    *y = from + (i + 0.4871) / ROWS * (to - from);
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

/* What orbits from all over the region have in common that go beyond the
 * window: there may be borders at infinity that nothing finds. */
static enum status look_around(struct plane_study *s, const struct inside *in,
                               struct plane_goal *goal)
{
    enum status status = STATUS_OK;
    struct plane_goal other;
    double y, lo = 0.0;

    for (int i = 0; i < ROWS; i += 5)
        for (int j = 1; j < 6; j += 2) {
            const double width = width_at(in, i, &y, &lo);
            if (!(width > 0.0) || goal->kind != PLANE_GOAL_BEYOND)
                continue;
            status =
                follow(s, (struct vec2){ lo + j / 6.0 * width, y }, &other);
            if (status != STATUS_OK)
                return status;
            if (other.kind != PLANE_GOAL_NONE && !meet(s, goal, &other))
                goal->kind = PLANE_GOAL_NONE;
        }
    return status;
}

/* The same, where curves that are not known may divide it (plane_border.h), of
 * all orbits, from one row. */
static enum status look_along(struct plane_study *s, const struct inside *in,
                              struct plane_goal *goal)
{
    static const double part[] = { 0.03, 0.17, 0.33, 0.67, 0.83, 0.97 };
    enum status status = STATUS_OK;
    struct plane_goal other;
    struct vec2 z;

    for (size_t i = 0; i < sizeof part / sizeof *part; i++) {
        if (goal->kind == PLANE_GOAL_NONE || !place_in(in, part[i], &z))
            break;
        status = follow(s, z, &other);
        if (status != STATUS_OK)
            break;
        if (!meet(s, goal, &other))
            goal->kind = PLANE_GOAL_NONE;
    }
    return status;
}

/* Whereto the inside of a region goes; cycles that are new are added. */
static enum status follow_region(struct patches *p, size_t region,
                                 struct plane_study *s, struct plane_goal *goal)
{
    const struct inside in = region_of(p, region);
    struct vec2 z;

    goal->kind = PLANE_GOAL_NONE;
    if (!place_in(&in, plane_label_between(0.0, 1.0), &z))
        return STATUS_OK;
    enum status status = follow(s, z, goal);
    if (status == STATUS_OK && plane_border_is_weak(s))
        status = look_along(s, &in, goal);
    return status ? status : look_around(s, &in, goal);
}

/* ---- patches ------------------------------------------------------------- */

enum { WITNESSES = 3 };

/* The largest regions of a patch, by area. */
static size_t largest(const struct patches *p, size_t patch,
                      size_t out[WITNESSES])
{
    size_t n = 0;

    for (size_t i = patch; i < p->r->count; i++) {
        if (plane_patch_of(p, i) != patch || !(p->area[i].value > 0.0))
            continue;
        size_t k = n < WITNESSES ? n++ : WITNESSES;
        for (; k > 0 && p->area[out[k - 1]].value < p->area[i].value; k--)
            if (k < WITNESSES)
                out[k] = out[k - 1];
        if (k < WITNESSES)
            out[k] = i;
    }
    return n;
}

static enum status find_goal(struct patches *p, size_t patch,
                             struct plane_study *s)
{
    size_t witness[WITNESSES];
    const size_t n = largest(p, patch, witness);
    struct plane_goal *goal = &p->goal[patch], other;
    enum status status = STATUS_OK;

    for (size_t k = 0; k < n && status == STATUS_OK; k++) {
        status = follow_region(p, witness[k], s, k == 0 ? goal : &other);
        if (k > 0 && !meet(s, goal, &other))
            goal->kind = PLANE_GOAL_NONE;
    }
    if (status == STATUS_OK && goal->kind == PLANE_GOAL_BEYOND)
        status = plane_beyond_add(s, &goal->beyond);
    return status;
}

enum status plane_label_all(struct plane_study *s, struct patches *p,
                            const struct monitor *monitor)
{
    enum status status = STATUS_OK;

    plane_patch_join(p);
    for (size_t i = 0; i < p->r->count && status == STATUS_OK; i++) {
        if (p->of[i] != i)
            continue;
        if (monitor_tell(monitor, "regions", i, p->r->count))
            return STATUS_STOPPED;
        status = find_goal(p, i, s);
    }
    if (status == STATUS_OK)
        status = plane_beyond_finish(s);
    for (size_t i = 0; i < p->r->count && status == STATUS_OK; i++) {
        const int8_t label = plane_label_of(s, &p->goal[plane_patch_of(p, i)]);
        p->r->region[i].label = label < 0 ? REGION_UNLABELLED : label;
    }
    return status;
}
