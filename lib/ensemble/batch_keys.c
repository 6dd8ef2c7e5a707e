#include "batch_keys.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "scene_parameter.h"
#include "scene_slope.h"
#include "schema.h"
#include "text.h"

enum status batch_keys_blame(struct fault *why, const char *name,
                             const char *what)
{
    return fault_set(why, STATUS_BAD_ARGUMENT, "%s: %s", text_shown(name).text,
                     what);
}

static enum status check_key(const struct batch *b, size_t k, struct fault *why)
{
    const char *path = b->key[k].path;

    if (b->scene->system ? !scene_parameter_is(b->scene, path)
                         : !scene_vary_is(&b->key[k]))
        return batch_keys_blame(
            why, path,
            b->scene->system ? "no parameter, expected system.parameters.NAME"
                             : "no key of a number, expected one such as "
                               "material.a");
    for (size_t i = 0; i < k; i++)
        if (strcmp(b->key[i].path, path) == 0 ||
            schema_excludes(b->key[i].path, path))
            return batch_keys_blame(why, path,
                                    "beside itself or a key that excludes it");
    return STATUS_OK;
}

/* Every draw has a slope. */
static enum status check_slope(const struct batch *b, struct fault *why)
{
    for (size_t k = 0; k < b->keys; k++)
        if (strncmp(b->key[k].path, "slope.", 6) == 0)
            return STATUS_OK;
    if (b->scene->system)
        return STATUS_OK;
    return scene_slope_demand(b->scene, 1u << PRODUCT_EQUILIBRIA, why);
}

enum status batch_keys_take(struct batch *b, const char *const key[],
                            size_t keys, struct fault *why)
{
    enum status status = STATUS_OK;

    b->key = calloc(keys + 1, sizeof *b->key);
    b->beyond = calloc(keys + 1, sizeof *b->beyond);
    if (b->key == NULL || b->beyond == NULL)
        return STATUS_NO_MEMORY;
    for (b->keys = 0; b->keys < keys && status == STATUS_OK; b->keys++) {
        const size_t k = b->keys;
        b->key[k] = scene_vary_at(b->scene, key[k]);
        status = check_key(b, k, why);
        if (status == STATUS_OK &&
            asprintf(&b->beyond[k], "%s is not allowed, expected %s", key[k],
                     scene_vary_expected(&b->key[k], b->scene)) < 0) {
            b->beyond[k] = NULL;
            status = STATUS_NO_MEMORY;
        }
    }
    return status ? status : check_slope(b, why);
}
