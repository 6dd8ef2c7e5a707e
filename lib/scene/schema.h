/* schema.h -- the one table of scene keys: what each holds, where it goes in
 * struct scene, its range and its default in words. */
#ifndef SCENE_SCHEMA_H
#define SCENE_SCHEMA_H

#include "node.h"
#include "scene.h"

struct schema_key;

/* Reads a node into the scene; errors as scene_read. */
typedef enum status schema_reader(const struct schema_key *key,
                                  const struct node *n, struct scene *s,
                                  struct fault *why);

struct schema_key {
    const char *path; /* "window.v" */
    schema_reader *read;
    size_t offset;             /* of the member of struct scene */
    const char *const *names;  /* words allowed, by code */
    double lo, hi;             /* lo < value < hi, or <= where closed */
    const char *expected;      /* what the value must be, for messages */
    const char *default_text;  /* for the documentation */
};

/* Ends with path NULL. */
extern const struct schema_key schema_table[];

/* Assigns every node of the tree through the table; refuses unknown keys. */
MUST_CHECK enum status schema_apply(const struct node *root, struct scene *s,
                                    struct fault *why);

#endif
