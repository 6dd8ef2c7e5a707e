#include "scatter.h"

#include <math.h>

#include "neighbours.h"
#include "scene_vary.h"
#include "study.h"
#include "study_results.h"

/* An input that is scattered. */
struct input {
    struct scene_vary vary;
    const struct scene_spread *spread;
};

/* What a nudge is relative to: X, or S where X is zero. */
static double scale_of(const struct input *in)
{
    const double x = in->spread->of[0];

    return x != 0.0 ? fabs(x) : in->spread->of[1];
}

static bool move(const void *ctx, double nudge, struct scene *c)
{
    const struct input *in = ctx;

    return scene_vary_set(&in->vary, in->spread->of[0] + nudge * scale_of(in),
                          c);
}

/* Squares are added up in the numbers themselves. */
static enum status add_input(struct neighbours *f,
                             const struct scene_spread *spread)
{
    const struct input in = { scene_vary_at(f->s->scene, spread->key), spread };
    const double times = spread->of[1] / scale_of(&in);
    struct neighbour_rate rate[NEIGHBOUR_NUMBERS];
    const enum status status = neighbours_rates(f, move, &in, rate);

    for (size_t i = 0; i < f->numbers.count && status == STATUS_OK; i++) {
        struct quantity *q = f->numbers.at[i];
        if (!quantity_exists(q))
            continue;
        q->spread = hypot(q->spread, times * rate[i].own);
        q->spread_si = hypot(q->spread_si, times * rate[i].si);
    }
    return status;
}

static enum status add_inputs(struct neighbours *f,
                              const struct monitor *monitor)
{
    const struct scene_ensemble *e = &f->s->scene->ensemble;
    enum status status = STATUS_OK;

    for (size_t i = 0; i < f->numbers.count; i++)
        if (quantity_exists(f->numbers.at[i]))
            f->numbers.at[i]->spread = f->numbers.at[i]->spread_si =
                f->same ? 0.0 : HUGE_VAL;
    for (size_t k = 0; k < e->scattered && f->same && !status; k++) {
        status = add_input(f, &e->parameter[k]);
        if (monitor_tell(monitor, "spread", k, e->scattered))
            status = STATUS_STOPPED;
    }
    return status;
}

enum status scatter_find(struct study *s, const struct monitor *monitor,
                         size_t *evaluations)
{
    struct neighbours f;
    enum status status =
        neighbours_init(&f, s, STUDY_NUMBERS | ASKED_BY(BASINS));

    if (status == STATUS_OK)
        status = add_inputs(&f, monitor);
    *evaluations += f.evaluations;
    neighbours_free(&f);
    return status;
}
