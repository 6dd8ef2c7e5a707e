/* run_plane.h -- what commands say of a system of formulas. */
#pragma once

#include "command.h"
#include "ensemble.h"
#include "json.h"
#include "plane_study.h"

/* As report_print and report_json of a law (report.h). */
MUST_CHECK enum status plane_print(const struct plane_study *s);
json_t *plane_json(const struct plane_study *s, const struct ensemble *drawn);

/* One stage of a plan, printed unless it is to be JSON, and on its list. */
void plan_row(const struct options *o, json_t *list, const char *name,
              const char *text, const char *work);

/* The stages of a system. */
void plane_plan(const struct options *o, json_t *list,
                const struct scene *scene);

/* The products of a scene that names none; bits. */
unsigned plane_products(const struct options *o);
