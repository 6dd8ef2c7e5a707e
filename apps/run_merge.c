/* slipway merge: the shares of a sweep or an ensemble. */
#include "command.h"
#include "ensemble.h"

enum exit_code command_merge(const struct options *o)
{
    struct scene scene;
    struct fault why;
    bool draws = false;

    if (command_read(o, NULL, 0, &scene, &why) == STATUS_OK) {
        draws = ensemble_is_asked(&scene);
        scene_free(&scene);
    }
    return draws ? command_ensemble(o) : command_sweep(o);
}
