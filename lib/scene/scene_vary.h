/* scene_vary.h -- a key of a scene that holds one number: found once by its
 * path, given values as often as one likes. */
#pragma once

#include "node.h"
#include "schema_table.h"

struct scene_vary {
    const char *path;             /* borrowed */
    const struct schema_key *key; /* NULL: a name of a system's or a law's */
    int own;                      /* of a law: which; -1: none */
    const struct unit *unit;      /* a bare value is in the scene's; NULL: it is
                                     what the scene holds */
};

/* The key of a scene's law at a path; `path` must outlive it.  A path that is
 * in no table is taken for a parameter of a system, which is not set here
 * (scene_parameter.h). */
struct scene_vary scene_vary_at(const struct scene *s, const char *path);

/* Whether the path is that of a number which can vary: a key of the schema that
 * holds a real one, or a name of the law's own. */
bool scene_vary_is(const struct scene_vary *v);

/* Gives the key a value; false, and the scene as it was, where that is out of
 * its range. */
bool scene_vary_set(const struct scene_vary *v, double x, struct scene *s);

/* Gives the scene the key's value x where it needs one and the tree has none: a
 * slope, V_c. */
void scene_vary_begin(const struct scene_vary *v, const struct node *root,
                      double x, struct scene *s);

/* STATUS_BAD_SCENE, blamed on `at` after the words `before`: a key of the
 * material, or a name of the law's own, that the law does not use. */
MUST_CHECK enum status scene_vary_check_used(const char *path,
                                             const struct scene *s,
                                             struct place at,
                                             const char *before,
                                             struct fault *why);

/* What values are allowed, as messages have it. */
const char *scene_vary_expected(const struct scene_vary *v,
                                const struct scene *s);
