#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "api.h"
#include "push.h"
#include "push_scatter.h"

struct slipway_push {
    struct scene scene;
    struct push push;
};

slipway_status slipway_push_open(const slipway_scene *scene,
                                 const slipway_monitor *monitor,
                                 slipway_push **out, slipway_fault *why)
{
    slipway_push *p = calloc(1, sizeof *p);
    struct fault fault = { "" };
    struct monitor tell;

    if (p == NULL)
        return api_fault(why, SLIPWAY_NO_MEMORY, status_text(STATUS_NO_MEMORY));
    slipway_status s = api_read(scene, &p->scene, why);
    if (s == SLIPWAY_OK) {
        const struct monitor *m = api_monitor(monitor, &tell);
        enum status status = push_init(&p->push, &p->scene, m, &fault);
        if (status == STATUS_OK)
            status = push_tabulate(&p->push, m);
        s = api_answer(why, status, &fault);
    }
    if (s == SLIPWAY_OK)
        *out = p;
    else
        slipway_push_free(p);
    return s;
}

static slipway_answer answer_of(const struct push_answer *a)
{
    return (slipway_answer){ (slipway_fate) a->fate, api_number(&a->slip),
                             api_number(&a->time),   api_number(&a->mu_mean),
                             api_number(&a->v_kick), api_number(&a->psi_kick) };
}

static slipway_status check(const struct push *p, const slipway_state state[],
                            size_t count, slipway_fault *why)
{
    char text[128];

    for (size_t i = 0; i < count; i++) {
        if (push_holds(p, (struct push_state){ state[i].v, state[i].psi }))
            continue;
        snprintf(
            text, sizeof text,
            "state %zu, v = %.17g, psi = %.17g, is outside [1e-300, 1e300]", i,
            state[i].v, state[i].psi);
        return api_fault(why, SLIPWAY_BAD_ARGUMENT, text);
    }
    return SLIPWAY_OK;
}

struct asked {
    const struct push_state *at;
    size_t count;
};

/* The same of every material, in V_star. */
static bool states_of(void *ctx, const struct scene *scene,
                      const struct slider *slider, struct push_state out[])
{
    const struct asked *a = ctx;

    (void) scene;
    (void) slider;
    memcpy(out, a->at, a->count * sizeof *out);
    return true;
}

slipway_status slipway_push_find(const slipway_push *push,
                                 const slipway_state state[], size_t count,
                                 const slipway_monitor *monitor,
                                 slipway_answer answer[], slipway_fault *why)
{
    struct push_state *at = malloc((count + 1) * sizeof *at);
    struct push_answer *found = malloc((count + 1) * sizeof *found);
    slipway_status s = check(&push->push, state, count, why);
    struct asked asked = { at, count };
    struct monitor tell;

    if (at == NULL || found == NULL)
        s = api_fault(why, SLIPWAY_NO_MEMORY, status_text(STATUS_NO_MEMORY));
    if (s == SLIPWAY_OK) {
        for (size_t i = 0; i < count; i++)
            at[i] = (struct push_state){ state[i].v, state[i].psi };
        const enum status status = push_scatter_find(
            &push->push, &(struct push_source){ states_of, &asked }, at, count,
            api_monitor(monitor, &tell), found);
        s = api_answer(why, status, NULL);
    }
    for (size_t i = 0; i < count && s == SLIPWAY_OK; i++)
        answer[i] = answer_of(&found[i]);
    free(at);
    free(found);
    return s;
}

void slipway_push_free(slipway_push *push)
{
    if (push == NULL)
        return;
    push_free(&push->push);
    scene_free(&push->scene);
    free(push);
}
