/* scene_sweep.h -- the axes of a sweep: from what its keys say to the values,
 * and from values to the scene at a point. */
#pragma once

#include "node.h"
#include "scene.h"

/* Lists the values of each axis that was read from root: from ... to in equal
 * steps, or equal steps of the logarithm, both ends exactly as given.  A slope
 * or V_c that the scene leaves out begins with the first of them.  Errors as
 * scene_read. */
MUST_CHECK enum status scene_sweep_fill(const struct node *root,
                                        struct scene *s, struct fault *why);

/* What only the whole scene can tell: the law uses the keys; what the products
 * give has the same shape at every point.  Errors as scene_read. */
MUST_CHECK enum status scene_sweep_check(const struct node *root,
                                         const struct scene *s,
                                         struct fault *why);

/* Whether the points have critical release distances, too: the scene says what
 * ball and block are. */
bool scene_sweep_releases(const struct scene *s);

/* Whether its figure has a log axis upward. */
bool scene_sweep_y_log(const struct scene_sweep *w);

/* Whether a key is one of the sweep's. */
bool scene_sweeps(const struct scene *s, const char *key);

/* The scene with its sweep's keys at x[0 .. axes - 1], values in their range.
 * What follows from them by default - the mass of spring_block - stays as it
 * was, and so does a system: scene_parameter.h.  *point borrows all that s
 * owns, and is not to be freed. */
void scene_at(const struct scene *s, const double x[], struct scene *point);
