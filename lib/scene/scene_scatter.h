/* scene_scatter.h -- inputs that are known to a standard deviation, "X +- S":
 * numbers below material, slope and system.parameters, and gravity, in a file
 * or an override.  The scene has X; S makes the input a parameter of the
 * scene's ensemble, normal, and gives every number of a study its spread. */
#pragma once

#include "node.h"
#include "scene.h"

/* Before the keys are read: "X" in place of "X +- S", and the ensemble's first
 * parameters.  STATUS_BAD_SCENE: S is no number > 0; STATUS_NO_MEMORY. */
MUST_CHECK enum status scene_scatter_take(struct node *root, struct scene *s,
                                          struct fault *why);

/* Where such an input stands, of an override as in `set`. */
enum { SCENE_SCATTER_SET = 256 };
struct place scene_scatter_place(const struct scene *s,
                                 const struct scene_spread *p,
                                 char set[SCENE_SCATTER_SET]);

/* STATUS_BAD_SCENE: such inputs, beside draws that come from a file. */
MUST_CHECK enum status scene_scatter_check(const struct scene *s,
                                           struct fault *why);

/* STATUS_BAD_SCENE where there are such inputs, blamed on the first: `what`
 * does not tell what they make of its numbers. */
MUST_CHECK enum status scene_scatter_refuse(const struct scene *s,
                                            const char *what,
                                            struct fault *why);
