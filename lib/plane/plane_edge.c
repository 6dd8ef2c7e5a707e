#include "plane_edge.h"

#include <float.h>

#include "plane_border.h"
#include "plane_orbit.h"
#include "plane_rest.h"

/* ---- between two states -------------------------------------------------- */

static struct vec2 middle_of(const struct plane_edge *e)
{
    return vec2_scale(0.5, vec2_add(e->z[0], e->z[1]));
}

/* Until no double is between them; *lost where the orbit of one goes nowhere
 * known. */
static enum status close_in(const struct plane_study *s, struct plane_edge *e,
                            plane_ask *ask, void *ctx, bool *lost)
{
    enum { HALVES = 60 };

    *lost = false;
    for (int i = 0; i < HALVES; i++) {
        const struct vec2 z = middle_of(e);
        struct plane_goal goal;
        if (vec2_length(arrival_from(&s->scale, z, e->z[0])) <= DBL_EPSILON)
            return STATUS_OK;
        const enum status status = ask(ctx, z, &goal);
        if (status != STATUS_OK)
            return status;
        *lost = goal.kind == PLANE_GOAL_NONE;
        if (*lost)
            return STATUS_OK;
        const int k = plane_goal_is_same(s, &goal, &e->goal[0]) ? 0 : 1;
        e->z[k] = z;
        e->goal[k] = goal;
    }
    return STATUS_OK;
}

/* ---- along the orbit between --------------------------------------------- */

/* Where an orbit is slower than before and after. */
enum { SLOW = 16 };
struct slow {
    const struct plane_study *s;
    struct vec2 last, at[SLOW];
    double speed[2]; /* at the last place and before it */
    size_t count;
};

static bool look(void *ctx, struct vec2 z, struct plane_goal *out)
{
    struct slow *w = ctx;
    const double speed = plane_study_speed(w->s, z);

    (void) out;
    if (w->speed[0] < w->speed[1] && w->speed[0] < speed && w->count < SLOW)
        w->at[w->count++] = w->last;
    w->speed[1] = w->speed[0];
    w->speed[0] = speed;
    w->last = z;
    return false;
}

enum status plane_edge_find(struct plane_study *s, struct plane_edge *e,
                            plane_ask *ask, void *ctx)
{
    struct slow slow = { .s = s };
    struct plane_rounds rounds = { .count = 0 };
    const struct plane_guide guide = { &rounds, look, &slow };
    struct plane_goal goal;
    size_t rest;
    bool lost;
    enum status status = close_in(s, e, ask, ctx, &lost);

    for (int k = 0; k < 2 && status == STATUS_OK; k++) {
        slow.speed[0] = slow.speed[1] = 0.0;
        status = plane_orbit(s, e->z[k], false, &guide, &goal);
        s->basin.steps += (int64_t) goal.steps;
    }
    for (size_t i = 0; i < slow.count && status == STATUS_OK; i++)
        status = plane_rest_add(s, slow.at[i], &rest);
    return status ? status : plane_border_look_from(s, middle_of(e));
}
