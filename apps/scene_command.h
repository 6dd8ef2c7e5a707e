/* scene_command.h -- which command a scene is for, where it does not say. */
#pragma once

#include "scene.h"

/* "sweep" for one with a sweep, "ensemble" for one with an ensemble; of those
 * that name no products, "rabinowicz" for one with that section and "simulate"
 * for one with starts of its own and no spread; else "study". */
const char *scene_command(const struct scene *s);
