#include "drawn.h"

#include "command.h"
#include "progress.h"

enum status drawn_check(const struct options *o, const struct scene *scene,
                        struct fault *why)
{
    return o->draws && scene->ensemble.scattered == 0
               ? command_refuse(why,
                                "%s: --draws: no input is X +- S, expected one "
                                "as in --set 'material.a=0.0349 +- 0.0005'",
                                o->command->name)
               : STATUS_OK;
}

enum status drawn_run(const struct options *o, const struct scene *scene,
                      struct ensemble *e, struct fault *why)
{
    const struct sweep_options how = { .version = SLIPWAY_VERSION };

    *e = ENSEMBLE_EMPTY;
    if (!scene->ensemble.is_drawn || scene->ensemble.scattered == 0)
        return STATUS_OK;
    const enum status s =
        ensemble_run(e, scene, &how, progress_monitor(o), why);
    progress_end();
    return s;
}

const struct ensemble *drawn_of(const struct ensemble *e)
{
    return e->scene ? e : NULL;
}
