/* run_plane.h -- commands on a scene with a system of formulas. */
#pragma once

#include "command.h"
#include "json.h"

/* Runs a study of the scene, writes, draws (`figure`, where the scene names no
 * output; NULL: nothing) and prints it. */
enum exit_code plane_run(const struct options *o, const struct scene *scene,
                         const char *figure);

/* One stage of a plan, printed unless it is to be JSON, and on its list. */
void plan_row(const struct options *o, json_t *list, const char *name,
              const char *text, const char *work);

/* The stages of a system. */
void plane_plan(const struct options *o, json_t *list,
                const struct scene *scene);

/* The products of a scene that names none; bits. */
unsigned plane_products(const struct options *o);
