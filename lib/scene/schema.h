/* schema.h -- finds keys in the table of them, assigns a tree of values, and
 * checks what the table alone can check. */
#pragma once

#include "schema_table.h"

/* The key at a path; NULL if there is none. */
const struct schema_key *schema_find(const char *path);

/* STATUS_BAD_SCENE, "unknown key ..." blamed on `at`, unless path is a key or
 * holds keys. */
MUST_CHECK enum status schema_check_path(const char *path, struct place at,
                                         struct fault *why);

/* STATUS_BAD_SCENE: n stands where the keys should be that the first `size`
 * letters of path hold. */
enum status schema_blame_section(const char *path, size_t size,
                                 const struct node *n, struct fault *why);

/* Whether the keys at two paths exclude each other. */
bool schema_excludes(const char *path, const char *other);

/* Assigns every value of the tree; refuses unknown keys, values out of range
 * and keys that exclude each other.  Errors as scene_read; part of the scene
 * may be assigned then. */
MUST_CHECK enum status schema_apply(const struct node *root, struct scene *s,
                                    struct fault *why);
