/*
 * plane_row.h -- one system of formulas as a row of a table spells it.
 *
 * Columns: scene (its file, relative to the working directory) and set
 * (settings KEY=VALUE as of --set, one a line); either may be empty.
 */
#pragma once

#include "scene.h"
#include "table.h"

/* Names of these columns; NULL-ended. */
extern const char *const plane_row_columns[];

/* Whether the rows of a table are systems: it has one of these columns. */
bool plane_row_is(const struct table *t);

/* The row's scene, which is to be freed, with these products instead of its
 * own.  Errors as scene_read; STATUS_BAD_SCENE also for a law on a slope. */
MUST_CHECK enum status plane_row_read(const struct table *t, size_t row,
                                      unsigned products, struct scene *scene,
                                      struct fault *why);
