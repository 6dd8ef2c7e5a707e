#include "batch_goal.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "batch_words.h"
#include "plane_answer.h"
#include "tolerance.h"

static const struct plane_rest *rest_of(const struct plane_study *s,
                                        const char *name)
{
    for (size_t i = 0; i < s->listed; i++)
        if (strcmp(s->rest[i].name, name) == 0)
            return &s->rest[i];
    return NULL;
}

/* False, and why, where there is none. */
static bool state_of(const struct plane_study *s, const struct scene_push *p,
                     double out[2], char why[128])
{
    const struct plane_rest *rest = p->from[0] ? rest_of(s, p->from) : NULL;
    bool good = rest || !p->from[0];

    snprintf(why, 128, "there is no %s", p->from);
    out[0] = p->v;
    out[1] = p->psi;
    for (int i = 0; i < 2 && rest; i++) {
        out[i] += rest->state[i].value;
        if (scene_axis_is_log(s->scene, i) && !(out[i] >= 1 / TOL_RANGE)) {
            snprintf(why, 128, "the pushed state has no %s > 0",
                     s->scene->system->state[i].name);
            good = false;
        }
    }
    return good;
}

/* How far the state is from another fate along the first axis, in the chart,
 * signed as it is above the boundary; infinite where it meets none. */
static double margin_of(const struct plane_study *s,
                        const struct plane_answer *a)
{
    const struct quantity *q = &a->kick[0];

    if (!quantity_exists(q))
        return HUGE_VAL;
    return scene_axis_is_log(s->scene, 0) ? -log(q->value) : -q->value;
}

static enum status find(const struct batch *b, const struct plane_study *s,
                        const struct scene_push *p, size_t i,
                        const struct batch_fates *f)
{
    struct plane_answer a = { .attractor = NULL };
    double state[2];
    char why[128];
    const bool there = state_of(s, p, state, why);
    const enum status status =
        there ? plane_answer_at(s, state, &a) : STATUS_OK;

    if (status != STATUS_OK)
        return status;
    f->fate[i] = there ? 0 : -1;
    f->margin[i] = there ? margin_of(s, &a) : HUGE_VAL;
    f->reason[i] = batch_words_keep(b->words, there ? a.attractor : why);
    return f->reason[i] ? STATUS_OK : STATUS_NO_MEMORY;
}

enum status batch_goal_find(const struct batch *b, const struct sweep_point *p,
                            size_t i, const struct batch_fates f[])
{
    enum status status = STATUS_OK;

    for (size_t k = 0; k < b->pushes && status == STATUS_OK; k++)
        status = find(b, &p->plane, &b->push[k], i, &f[k]);
    return status;
}
