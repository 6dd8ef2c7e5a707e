#include "near_runs.h"

/* With a limit of the scene's a run need not reach its end. */
static bool is_asked(const struct scene *scene, const struct transient *t)
{
    return t->sum.end == TRANSIENT_NEAR && t->sum.fate != FATE_UNDECIDED &&
           !(scene->until_time > 0.0) && !(scene->until_slip > 0.0);
}

static void take(const struct quantity *told, struct quantity *q)
{
    if (quantity_exists(told))
        *q = *told;
}

static enum status tell(const struct push *p, const struct monitor *monitor,
                        struct transient_summary *sum)
{
    struct push_answer a;
    const struct push_state at = { sum->v, sum->psi };
    const enum status s = push_find(p, at, monitor, &a);

    if (s != STATUS_OK || a.fate != sum->fate)
        return s;
    take(&a.time, &sum->time);
    take(&a.slip, &sum->slip);
    take(&a.mu_mean, &sum->mu_mean);
    return s;
}

enum status near_runs_tell(const struct scene *scene, size_t count,
                           const struct monitor *monitor,
                           struct transient run[])
{
    enum status s = STATUS_OK;
    struct push p;
    struct fault why;
    size_t first = 0;

    while (first < count && !is_asked(scene, &run[first]))
        first++;
    if (first == count)
        return s;
    s = push_init(&p, scene, monitor, &why);
    if (s != STATUS_OK)
        return s;
    s = push_tabulate(&p, monitor);
    for (size_t i = first; i < count && s == STATUS_OK; i++)
        if (is_asked(scene, &run[i]))
            s = tell(&p, monitor, &run[i].sum);
    push_free(&p);
    return s;
}
