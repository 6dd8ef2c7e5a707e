#include "api.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "room.h"
#include "unit.h"

static const struct {
    enum status status;
    slipway_status told;
} told[] = {
    { STATUS_OK, SLIPWAY_OK },
    { STATUS_NO_MEMORY, SLIPWAY_NO_MEMORY },
    { STATUS_BAD_ARGUMENT, SLIPWAY_BAD_ARGUMENT },
    { STATUS_STOPPED, SLIPWAY_STOPPED },
    { STATUS_BAD_SCENE, SLIPWAY_BAD_SCENE },
    { STATUS_IO, SLIPWAY_IO },
};

slipway_status api_status(enum status s)
{
    for (size_t i = 0; i < sizeof told / sizeof *told; i++)
        if (told[i].status == s)
            return told[i].told;
    return SLIPWAY_NUMERICAL;
}

const char *slipway_status_text(slipway_status status)
{
    for (size_t i = 0; i < sizeof told / sizeof *told; i++)
        if (told[i].told == status)
            return status_text(told[i].status);
    return status_text(STATUS_NO_CONVERGENCE);
}

const char *slipway_version(void)
{
    return SLIPWAY_VERSION;
}

slipway_number api_number(const struct quantity *q)
{
    return (slipway_number){ q->value, q->error, q->reason, q->spread };
}

bool api_is_number(const struct sweep_column *c)
{
    return c->codes == NULL && c->dims == 0;
}

slipway_label api_labelled(const char *name, const char *unit, const char *text)
{
    return (slipway_label){ name, unit_plain(unit), unit_factor(unit), text };
}

slipway_label api_label(const struct sweep_columns *c, size_t k)
{
    for (size_t i = 0; i < c->count; i++)
        if (api_is_number(&c->at[i]) && k-- == 0)
            return api_labelled(c->at[i].name, c->at[i].unit, c->at[i].text);
    return (slipway_label){ NULL, NULL, NULL, NULL };
}

const struct monitor *api_monitor(const slipway_monitor *in,
                                  struct monitor *out)
{
    if (in == NULL)
        return NULL;
    *out = (struct monitor){ in->tell, in->ctx };
    return out;
}

slipway_status api_fault(slipway_fault *why, slipway_status status,
                         const char *text)
{
    if (why)
        snprintf(why->text, sizeof why->text, "%s", text);
    return status;
}

slipway_status api_answer(slipway_fault *why, enum status s,
                          const struct fault *fault)
{
    const char *text = fault && fault->text[0] ? fault->text : status_text(s);

    return s == STATUS_OK ? SLIPWAY_OK : api_fault(why, api_status(s), text);
}

/* ---- scenes -------------------------------------------------------------- */

slipway_status slipway_scene_new(slipway_scene **out)
{
    slipway_scene *scene = calloc(1, sizeof *scene);

    if (scene == NULL)
        return SLIPWAY_NO_MEMORY;
    *out = scene;
    return SLIPWAY_OK;
}

slipway_status slipway_scene_read(const char *path, slipway_scene **out,
                                  slipway_fault *why)
{
    slipway_scene *scene = NULL;
    struct scene read;
    slipway_status s = slipway_scene_new(&scene);

    if (s == SLIPWAY_OK) {
        scene->path = strdup(path);
        s = scene->path ? api_read(scene, &read, why) : SLIPWAY_NO_MEMORY;
        if (s == SLIPWAY_OK)
            scene_free(&read);
    }
    if (s == SLIPWAY_OK)
        *out = scene;
    else
        slipway_scene_free(scene);
    return s == SLIPWAY_NO_MEMORY ? api_fault(why, s, slipway_status_text(s))
                                  : s;
}

slipway_status slipway_scene_set(slipway_scene *scene, const char *key,
                                 const char *value)
{
    char *line = NULL;

    if (ROOM_FOR(scene->set, scene->room, scene->sets + 1) ||
        asprintf(&line, "%s=%s", key, value) < 0)
        return SLIPWAY_NO_MEMORY;
    scene->set[scene->sets++] = line;
    return SLIPWAY_OK;
}

slipway_status slipway_scene_set_number(slipway_scene *scene, const char *key,
                                        double value)
{
    char text[32];

    snprintf(text, sizeof text, "%.17g", value);
    return slipway_scene_set(scene, key, text);
}

slipway_status api_read(const slipway_scene *scene, struct scene *out,
                        slipway_fault *why)
{
    struct fault fault = { "" };
    const enum status s =
        scene_read(out, scene->path, scene->set, scene->sets, &fault);

    return api_answer(why, s, &fault);
}

#define BIT(p) (1u << PRODUCT_##p)

unsigned api_products(const struct scene *scene)
{
    return scene->products || scene->system
               ? scene->products
               : BIT(EQUILIBRIA) | BIT(FOLDS) | BIT(KNEES) | BIT(ESTIMATES);
}

slipway_axis api_axis(const struct scene *scene, int axis)
{
    static const char *const friction[] = { "v", "psi" };
    const double *range = axis ? scene->window.psi : scene->window.v;

    return (slipway_axis){ scene->system ? scene->system->state[axis].name
                                         : friction[axis],
                           scene_axis_is_log(scene, axis),
                           { range[0], range[1] } };
}

void slipway_scene_free(slipway_scene *scene)
{
    if (scene == NULL)
        return;
    for (size_t i = 0; i < scene->sets; i++)
        free(scene->set[i]);
    free(scene->set);
    free(scene->path);
    free(scene);
}
