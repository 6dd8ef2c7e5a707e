#include "start_numbers.h"

#include "near_runs.h"

static struct transient_event none(void)
{
    const struct quantity q = quantity_none("it does not happen in this run");

    return (struct transient_event){ -1, 0.0, q, q, q, q, q };
}

static bool is_there(const struct transient_event *e)
{
    return e->what >= 0;
}

/* Events come in the order of time: the first of a kind stays. */
static void note(const struct transient_event *e, struct transient_event *place)
{
    if (!is_there(place))
        *place = *e;
}

static void note_level(const struct transient_event *e,
                       const struct transient_options *o,
                       struct transient_event place[])
{
    for (size_t i = 0; i < o->levels; i++)
        if (e->level == o->level[i].value)
            note(e, &place[i]);
}

static void sort_events(const struct transient *t,
                        const struct transient_options *o,
                        struct start_numbers *out)
{
    for (int i = 0; i < MOMENTS; i++)
        out->first[i] = none();
    for (int i = 0; i < MOMENT_LEVELS_MAX; i++)
        out->nears[i] = out->leaves[i] = none();
    for (size_t i = 0; i < t->events; i++) {
        const struct transient_event *e = &t->event[i];
        note(e, &out->first[e->what]);
        if (e->what == MOMENT_MU_NEARS)
            note_level(e, o, out->nears);
        if (e->what == MOMENT_MU_LEAVES)
            note_level(e, o, out->leaves);
    }
}

enum status start_numbers_find(const struct study *s, struct scene_start start,
                               const struct monitor *monitor,
                               struct start_numbers *out)
{
    const struct transient_options o = transient_defaults(s->scene);
    struct transient t;
    enum status status = transient_find(&s->slider, start, &o, monitor, &t);

    if (status != STATUS_OK)
        return status;
    status = near_runs_tell(s->scene, 1, monitor, &t);
    out->sum = t.sum;
    for (int i = 0; i < PHASES; i++)
        out->phase[i] = t.phase[i];
    sort_events(&t, &o, out);
    transient_free(&t);
    return status;
}
