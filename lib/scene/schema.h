/*
 * schema.h -- the one table of scene keys: what each holds, where it goes in
 * struct scene, and its range; and what the table alone can check.
 */
#ifndef SCENE_SCHEMA_H
#define SCENE_SCHEMA_H

#include "node.h"
#include "scene.h"

struct schema_key {
    const char *path; /* "window.v" */
    /* Reads a value into the scene; errors as scene_read. */
    enum status (*read)(const struct schema_key *key, const struct node *n,
                        struct scene *s, struct fault *why);
    size_t offset;            /* of a member of struct scene, if there is one */
    double lo, hi;            /* of numbers */
    bool open_lo, open_hi;    /* lo (hi) itself is not allowed */
    const char *const *words; /* allowed, by code; NULL-ended */
    const char *expected;     /* for messages; NULL: the words */
    int side; /* keys of one section on different sides exclude each other; 0:
                 on none */
};

/* Words of sweep.show by code, NULL-ended. */
extern const char *const sweep_show_names[];

/* Ends with path NULL. */
enum { SCHEMA_KEYS_MAX = 128 };
extern const struct schema_key schema_table[];

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

#endif
