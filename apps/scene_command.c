#include "scene_command.h"

#include <stddef.h>

static bool has_rabinowicz(const struct scene_rabinowicz *r)
{
    return r->block_mass > 0.0 || r->ball_mass > 0.0 || r->restitution >= 0.0 ||
           r->slopes > 0 || r->data != NULL;
}

const char *scene_command(const struct scene *s)
{
    if (s->sweep.axes > 0)
        return "sweep";
    if (s->ensemble.parameters > s->ensemble.scattered || s->ensemble.samples ||
        s->ensemble.covariance)
        return "ensemble";
    if (s->system)
        return "study";
    if (s->products == 0 && has_rabinowicz(&s->rabinowicz))
        return "rabinowicz";
    if (s->products == 0 && s->starts > 0 && s->spread == 0)
        return "simulate";
    return "study";
}
