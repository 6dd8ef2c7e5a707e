/* scene_units.h -- what a scene says in physical units, made dimensionless; and
 * states as users write them elsewhere.
 *
 * A slip rate may have its unit behind it, m/s or V_star; a state is psi, which
 * is dimensionless, or phi, in the units of its law (physical.h).  In a scene
 * with `units: si` a number that could mean either is refused: slip rates need
 * a unit, states are phi.  Only in trajectories.starts, of which `units` says
 * so, a bare v is in m/s then. */
#ifndef SCENE_SCENE_UNITS_H
#define SCENE_SCENE_UNITS_H

#include "node.h"
#include "scene.h"

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

#endif
