/* scene_ensemble.h -- the ensemble of a scene: what varies at random, how many
 * draws, and the states whose fates are asked for. */
#pragma once

#include "scene_vary.h"

/* Readers of schema.h. */
VALUE_READER(value_spreads);
VALUE_READER(value_numbers);

/* One more parameter of that key, which is copied; NULL without memory. */
struct scene_spread *scene_ensemble_add(struct scene_ensemble *e,
                                        const char *key);

/* Words of a parameter's law and of ensemble.method, by code; NULL-ended. */
extern const char *const spread_names[], *const ensemble_method_names[];

/* What only the whole tree can tell: pushes in their units, and a slope or V_c
 * that the scene leaves out begins with its median.  Errors as scene_read. */
MUST_CHECK enum status scene_ensemble_settle(const struct node *root,
                                             struct scene *s,
                                             struct fault *why);

/* And what only the whole scene can: each parameter is the key of a number that
 * the law uses, once, and its median is allowed.  Errors as scene_read. */
MUST_CHECK enum status scene_ensemble_check(const struct node *root,
                                            const struct scene *s,
                                            struct fault *why);

/* That a key can vary: as scene_ensemble_check, blamed on `at`. */
MUST_CHECK enum status scene_ensemble_check_key(const struct scene *s,
                                                const char *path,
                                                struct place at,
                                                struct fault *why);

/* Whether a key is, or may be, one of the ensemble's. */
bool scene_ensemble_has(const struct scene *s, const char *key);

void scene_ensemble_free(struct scene_ensemble *e);
