/* run_plane.h -- commands on a scene with a system of formulas. */
#pragma once

#include "command.h"

/* Runs a study of the scene, writes, draws (`figure`, where the scene names no
 * output; NULL: nothing) and prints it. */
enum exit_code plane_run(const struct options *o, const struct scene *scene,
                         const char *figure);

/* Says what would be run. */
enum exit_code plane_plan(const struct options *o, const struct scene *scene);

/* The products of a scene that names none; bits. */
unsigned plane_products(const struct options *o);
