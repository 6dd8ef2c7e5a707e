/* scene_parameter.h -- the parameters of a scene's system as keys:
 * "system.parameters.NAME". */
#pragma once

#include "node.h"
#include "scene.h"

/* Those of s->system into s->parameter_key, owned by *s.  STATUS_BAD_SCENE:
 * one, below n or else in the statements, is in no formula; STATUS_NO_MEMORY.
 */
MUST_CHECK enum status scene_parameter_keys(struct scene *s,
                                            const struct node *n,
                                            const struct node *ode,
                                            struct fault *why);

/* Whether that is the key of one; of a scene with a system. */
bool scene_parameter_is(const struct scene *s, const char *key);

/* Sets the parameter of that key, a number as its shortest decimal says: a
 * study with --set KEY=DECIMAL has the same.  STATUS_BAD_SCENE where the
 * formulas cannot be read with it. */
MUST_CHECK enum status scene_parameter_set(struct formula_system *f,
                                           const char *key, double x);
