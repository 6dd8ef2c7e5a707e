#include "plane_goal.h"

#include "plane_beyond.h"
#include "plane_rest.h"

const char *const plane_unknown_texts[PLANE_UNKNOWNS] = {
    [PLANE_UNKNOWN_CLOSED] =
        "closed orbits are not told to attract those beside them, as where "
        "something is conserved",
    [PLANE_UNKNOWN_LOST] =
        "orbits come so near to an equilibrium that is not hyperbolic, to a "
        "box that may hold one, to a closed orbit, or to where formulas may "
        "have no values, that rounding decides",
    [PLANE_UNKNOWN_STEPS] =
        "orbits are not at an end after all the steps that they may take",
    [PLANE_UNKNOWN_WORK] = "the work for labels was spent",
    [PLANE_UNKNOWN_CELLS] =
        "cells lie beside others that go elsewhere, where no curve that parts "
        "them is known",
    [PLANE_UNKNOWN_BORDER] =
        "a stable manifold goes round more often than steps allow: beyond its "
        "last turn both of its sides are one region",
};

static size_t traps_before(const struct plane_study *s, size_t rest)
{
    size_t n = 0;

    for (size_t i = 0; i < rest; i++)
        n += plane_rest_attracts(&s->rest[i], false);
    return n;
}

size_t plane_goal_beyond(const struct plane_study *s)
{
    return traps_before(s, s->rests);
}

int8_t plane_goal_label(const struct plane_study *s, const struct plane_goal *g)
{
    size_t n = plane_goal_beyond(s);

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
    size_t n = 0;

    for (size_t i = 0; i < s->rests; i++)
        if (plane_rest_attracts(&s->rest[i], false) && n++ == (size_t) label)
            return i >= s->listed;
    if (label < 0 || (size_t) label < n + s->beyonds)
        return label >= 0;
    n += s->beyonds;
    for (size_t k = 0; k < s->cycles; k++)
        if (s->cycle[k].type == PLANE_CYCLE_STABLE && n++ == (size_t) label)
            return !box_holds(s->window.box, s->cycle[k].round.at[0]);
    return false;
}

bool plane_goal_allows(const struct plane_study *s, int8_t label,
                       const struct plane_goal *g)
{
    const size_t n = plane_goal_beyond(s), i = (size_t) label - n;

    if (g->kind == PLANE_GOAL_LEFT)
        return is_outside(s, label);
    if (g->kind == PLANE_GOAL_BEYOND && label >= 0 && (size_t) label >= n &&
        i < s->beyonds)
        return plane_beyond_agree(s, &s->beyond[i], &g->beyond);
    return label == plane_goal_label(s, g);
}

bool plane_goal_is_same(const struct plane_study *s, const struct plane_goal *a,
                        const struct plane_goal *b)
{
    if (a->kind != b->kind || a->kind == PLANE_GOAL_LEFT)
        return a->kind == b->kind;
    return a->kind == PLANE_GOAL_BEYOND
               ? plane_beyond_agree(s, &a->beyond, &b->beyond)
               : a->index == b->index;
}

/* Whether it is of something outside the window. */
static bool is_beyond(const struct plane_study *s, const struct plane_goal *g)
{
    return g->kind == PLANE_GOAL_LEFT || g->kind == PLANE_GOAL_BEYOND ||
           (g->kind == PLANE_GOAL_REST && g->index >= s->listed) ||
           (g->kind == PLANE_GOAL_CYCLE &&
            !box_holds(s->window.box, g->round.at[0]));
}

bool plane_goal_meet(const struct plane_study *s, struct plane_goal *a,
                     const struct plane_goal *b)
{
    if (b->kind == PLANE_GOAL_LEFT)
        return is_beyond(s, a);
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
