/*
 * scene_law.h -- a law that the scene writes as formulas:
 *
 *     law: {theta: "ln(c + psi)", psi_ss: "(1 + R)/(1 + R*v)", T: "R*psi_ss",
 *           K: "sinh(d)", state: positive}
 *
 * with d = psi - psi_ss, or `rate` (dpsi/dt) for T and K, or `mu` for the form
 * of friction; a component's word stands for its formula.  Numbers under
 * `material` that the model does not know are names of the law's own.
 */
#pragma once

#include "node.h"
#include "scene.h"

/* Whether there are formulas. */
bool scene_law_is_typed(const struct node *root);

/* Before the keys are read: s->typed, where there are. */
MUST_CHECK enum status scene_law_begin(const struct node *root,
                                       struct scene *s);

/* Whether the path is one word under `material`; if it is no key, it may be a
 * name of such a law's own. */
bool scene_law_may_own(const char *path);

/* Its number.  Errors as scene_read. */
MUST_CHECK enum status scene_law_own(const struct node *n, struct scene *s,
                                     struct fault *why);

/* "material.NAME" for a key of a sweep, which lives as long as s->typed; NULL:
 * it is none, or one of the schema's. */
const char *scene_law_key(struct scene *s, const char *path);

/* The own name's number in s->material, by such a key; -1: there is none. */
int scene_law_find(const struct scene *s, const char *path);

/* After the keys are read: reads the formulas, s->law. */
MUST_CHECK enum status scene_law_finish(const struct node *root,
                                        struct scene *s, struct fault *why);
