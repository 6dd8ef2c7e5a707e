/*
 * schema_table.h -- the one table of scene keys: what each holds, where it
 * goes in struct scene, its range, and what a reader of scenes must know.
 */
#pragma once

#include "node.h"
#include "scene.h"
#include "unit_text.h"

struct schema_key {
    const char *path; /* "window.v" */
    /* Reads a value into the scene; errors as scene_read.  NULL: it is taken
     * out of the tree before (scene_system.h). */
    enum status (*read)(const struct schema_key *key, const struct node *n,
                        struct scene *s, struct fault *why);
    size_t offset;            /* of a member of struct scene, if there is one */
    double lo, hi;            /* of numbers */
    bool open_lo, open_hi;    /* lo (hi) itself is not allowed */
    const char *const *words; /* allowed, by code; NULL-ended */
    const char *expected;     /* for messages; NULL: the words */
    int side;  /* keys of one section on different sides exclude each other; 0:
                  on none */
    bool open; /* holds keys that the user names */
    const char *unit; /* UDUNITS, or one of unit.h, which may stand behind the
                         number; NULL: none */
    const char *standard; /* what a scene without the key has, as it would say
                             it; NULL: nothing, or see text */
    const char *text;     /* what it is, one phrase */
};

/* Declares, or begins, a reader. */
#define VALUE_READER(name)                                                     \
    enum status name(const struct schema_key *key, const struct node *n,       \
                     struct scene *s, struct fault *why)

/* Words of sweep.show by code, NULL-ended. */
extern const char *const sweep_show_names[];

/* Ends with path NULL. */
enum { SCHEMA_KEYS_MAX = 128 };
extern const struct schema_key schema_table[];
