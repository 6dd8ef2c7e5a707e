#include "batch_goal.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "plane_answer.h"
#include "tolerance.h"

/* ---- words --------------------------------------------------------------- */

void batch_words_free(struct batch_words *w)
{
    for (size_t i = 0; i < w->count; i++)
        free(w->text[i]);
    w->count = 0;
}

/* The same text, that stays; beyond the room for them one for all others;
 * NULL: no memory. */
static const char *keep(struct batch_words *w, const char *text)
{
    const char *kept = "others";
    size_t i = 0;

#pragma omp critical(batch_words)
    {
        while (i < w->count && strcmp(w->text[i], text) != 0)
            i++;
        if (i == w->count && i < REASONS_MAX && (w->text[i] = strdup(text)))
            w->count++;
        if (i < REASONS_MAX)
            kept = i < w->count ? w->text[i] : NULL;
    }
    return kept;
}

/* ---- states -------------------------------------------------------------- */

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
    f->reason[i] = keep(b->words, there ? a.attractor : why);
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
