/* node.h -- a YAML document as a tree that remembers where things stand. */
#ifndef SCENE_NODE_H
#define SCENE_NODE_H

#include <stddef.h>

#include "status.h"

enum node_kind { NODE_SCALAR, NODE_LIST, NODE_MAP };

struct node {
    enum node_kind kind;
    char *key;  /* owned; NULL in a list and at the top */
    char *text; /* owned; scalars only */
    char *where; /* owned: "FILE:LINE:COL" or "--set KEY=VALUE" */
    struct node **child; /* owned */
    size_t count;
    struct node *parent; /* borrowed */
};

/* A whole document; an empty one is an empty map.  `name` stands in messages.
 * STATUS_BAD_SCENE with one line in *why, STATUS_NO_MEMORY; *out is then
 * NULL. */
MUST_CHECK enum status node_parse(const char *text, size_t size,
                                  const char *name, struct node **out,
                                  struct fault *why);

/* Sets the value at a dotted key, e.g. "window.v", in the tree: `value` is
 * parsed as YAML, replacing what is there.  Same errors. */
MUST_CHECK enum status node_override(struct node *root, const char *set,
                                     struct fault *why);

/* The child with this key; NULL if there is none. */
struct node *node_find(const struct node *map, const char *key);

/* Removes the child with this key, if any. */
void node_remove(struct node *map, const char *key);

/* NULL is harmless. */
void node_free(struct node *n);

/* "where: text" with control characters made visible; returns
 * STATUS_BAD_SCENE. */
enum status node_blame(const struct node *n, struct fault *why,
                       const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* Text as one printable line: control characters and bytes that are not ASCII
 * controls escaped as \xNN, cut at size - 1. */
void node_printable(const char *text, char *out, size_t size);

#endif
