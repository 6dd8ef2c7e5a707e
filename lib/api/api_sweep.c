#include <stdlib.h>

#include "api.h"
#include "scene_scatter.h"
#include "sweep.h"

struct slipway_sweep {
    struct scene scene;
    struct sweep sweep;
};

slipway_status slipway_sweep_run(const slipway_scene *scene,
                                 const slipway_monitor *monitor,
                                 slipway_sweep **out, slipway_fault *why)
{
    slipway_sweep *w = calloc(1, sizeof *w);
    struct fault fault = { "" };
    struct monitor tell;

    if (w == NULL)
        return api_fault(why, SLIPWAY_NO_MEMORY, status_text(STATUS_NO_MEMORY));
    slipway_status s = api_read(scene, &w->scene, why);
    if (s == SLIPWAY_OK)
        s = api_answer(why, scene_scatter_refuse(&w->scene, "sweep", &fault),
                       &fault);
    if (s == SLIPWAY_OK && w->scene.sweep.axes == 0)
        s = api_fault(why, SLIPWAY_BAD_SCENE,
                      "the scene has no sweep, expected sweep.key and values");
    w->scene.products = api_products(&w->scene);
    if (s == SLIPWAY_OK) {
        const enum status status =
            sweep_run(&w->sweep, &w->scene, &(struct sweep_options){ 0 },
                      api_monitor(monitor, &tell), &fault);
        s = api_answer(why, status, &fault);
    }
    if (s == SLIPWAY_OK)
        *out = w;
    else
        slipway_sweep_free(w);
    return s;
}

const double *slipway_sweep_axis(const slipway_sweep *sweep, size_t axis,
                                 size_t *count, slipway_label *key)
{
    static const struct sweep_axis none = { .key = { 0 } };
    const struct sweep_axis *a =
        axis < sweep->sweep.axes ? &sweep->sweep.axis[axis] : &none;

    *count = a->count;
    if (key)
        *key = a->value ? api_labelled(a->key.path, a->key.unit, a->key.text)
                        : (slipway_label){ NULL, NULL, NULL, NULL };
    return a->value;
}

slipway_label slipway_sweep_label(const slipway_sweep *sweep, size_t k)
{
    return api_label(&sweep->sweep.columns, k);
}

slipway_status slipway_sweep_numbers(const slipway_sweep *sweep,
                                     const char *name, slipway_number out[],
                                     size_t count)
{
    const struct sweep *w = &sweep->sweep;
    const int column = sweep_find(w, name);

    if (column < 0 || count != w->points ||
        !api_is_number(&w->columns.at[column]))
        return SLIPWAY_BAD_ARGUMENT;
    for (size_t i = 0; i < count; i++) {
        const struct quantity q = sweep_quantity(w, column, i);
        out[i] = api_number(&q);
    }
    return SLIPWAY_OK;
}

void slipway_sweep_free(slipway_sweep *sweep)
{
    if (sweep == NULL)
        return;
    sweep_free(&sweep->sweep);
    scene_free(&sweep->scene);
    free(sweep);
}
