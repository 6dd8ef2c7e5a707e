#include "goal_scatter.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "normal.h"
#include "plane_scatter.h"

struct job {
    const double (*state)[2];
    struct plane_answer *answer;
    size_t count;
};

/* The kicks of a neighbour, of states that go where they did. */
static enum status kicks_of(void *ctx, const struct plane_study *s,
                            struct quantity q[])
{
    const struct job *j = ctx;
    enum status status = STATUS_OK;

    for (size_t i = 0; i < j->count && status == STATUS_OK; i++) {
        struct plane_answer a;
        status = plane_answer_at(s, j->state[i], &a);
        if (status == STATUS_OK &&
            strcmp(a.attractor, j->answer[i].attractor) == 0)
            memcpy(q + 2 * i, a.kick, sizeof a.kick);
    }
    return status;
}

/* |k|/s; NaN where s is not known. */
static double distance(const struct quantity *q, bool is_log)
{
    if (!quantity_exists(q) || !(q->spread > 0.0) || isinf(q->spread))
        return (double) NAN;
    return is_log ? fabs(log(q->value)) * q->value / q->spread
                  : fabs(q->value) / q->spread;
}

enum status goal_scatter_find(const struct plane_study *s,
                              const double state[][2], size_t count,
                              const struct monitor *monitor,
                              struct plane_answer answer[])
{
    struct job j = { state, answer, count };
    struct quantity **q = calloc(2 * count + 1, sizeof *q);

    if (q == NULL)
        return STATUS_NO_MEMORY;
    for (size_t i = 0; i < 2 * count; i++)
        q[i] = &answer[i / 2].kick[i % 2];
    const enum status status =
        plane_scatter_find(s, kicks_of, &j, 2 * count, monitor, q);
    for (size_t i = 0; i < count && status == STATUS_OK; i++) {
        const double off =
            fmin(distance(q[2 * i], scene_axis_is_log(s->scene, 0)),
                 distance(q[2 * i + 1], scene_axis_is_log(s->scene, 1)));
        answer[i].stays = isnan(off) ? off : normal_below(off);
    }
    free(q);
    return status;
}
