/* scene_system.h -- a scene's `system`: a planar system of formulas in place of
 * a law on a slope, its window and its starts, by the states' own names. */
#pragma once

#include "node.h"
#include "scene.h"
#include "system.h"

/* Products (bits) that every planar system has. */
extern const unsigned scene_system_products;

/* Reads what the tree says of the system, if it has one, into *s, of which
 * v and psi of window and starts are the first and the second state then, and
 * takes it out of the tree.  Errors as scene_read. */
MUST_CHECK enum status scene_system_take(struct node *root, struct scene *s,
                                         struct fault *why);

/* What only the whole scene can tell.  Errors as scene_read. */
MUST_CHECK enum status scene_system_check(const struct node *root,
                                          const struct scene *s,
                                          struct fault *why);

/* Whether the node is a number, *x, that a state of this chart may have; and
 * what is expected of one. */
bool scene_system_is_state(const struct node *n, enum formula_chart chart,
                           double *x);
const char *scene_system_expected(enum formula_chart chart);
