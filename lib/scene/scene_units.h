/* scene_units.h -- what a scene says in physical units, made dimensionless; and
 * states as users write them elsewhere.
 *
 * A slip rate, a time or a length may have its unit behind it, m/s or V_star; a
 * bare one is in the scene's units.  A state is psi, which is dimensionless, or
 * phi, in the units of its law (physical.h); beside `units: si` it is phi. */
#pragma once

#include "node.h"
#include "scene.h"
#include "unit.h"

/* The units that numbers of the scene are told in. */
struct unit_system scene_units(const struct scene *s);

/* To be called when the tree's values are in *s, as they stand there. */
MUST_CHECK enum status scene_units_settle(const struct node *root,
                                          struct scene *s, struct fault *why);

/* Where v, psi and phi of a state come from; NULL: not given. */
struct scene_state {
    const char *v, *psi, *phi;
};

/* Reads one outside the scene.  False where that is none: *wrong then is which
 * of the texts, or NULL where one is missing, and `expected` says what was. */
bool scene_state_read(const struct scene *s, const struct scene_state *text,
                      struct scene_start *out, const char **wrong,
                      char expected[128]);
