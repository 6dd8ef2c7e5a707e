/* node.h -- a YAML document as a tree that remembers where things stand. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "status.h"
#include "text.h"

/* A point of a file, or an override as a whole. */
struct place {
    const char *name;    /* borrowed: file, or KEY=VALUE; NULL: neither */
    bool is_set;         /* name is KEY=VALUE of --set */
    size_t line, column; /* of a file, from 1; 0: no line is meant */
};

enum node_kind { NODE_SCALAR, NODE_LIST, NODE_MAP };

struct node {
    enum node_kind kind;
    struct place at;     /* of the value */
    struct place key_at; /* of its key, if it has one */
    char *key;           /* owned; NULL in a list and at the top */
    char *text;          /* owned; scalars only */
    struct node **child; /* owned; lists and maps only */
    size_t count;
};

/* An empty node; NULL without memory. */
struct node *node_new(enum node_kind kind, struct place at);

/* Gives the child away to a list or, with its key set, to a map; without
 * memory frees it and returns STATUS_NO_MEMORY. */
MUST_CHECK enum status node_adopt(struct node *parent, struct node *child);

/* Copies a key into n, of which it is `at`; STATUS_NO_MEMORY, n as it was. */
MUST_CHECK enum status node_set_key(struct node *n, const char *key,
                                    size_t size, struct place at);

/* The child with this key, NULL if there is none; NULL has no children. */
struct node *node_find(const struct node *map, const char *key);

/* Below root at a dotted path, such as "window.v"; NULL if there is none. */
const struct node *node_at(const struct node *root, const char *path);

/* Removes child number i. */
void node_remove(struct node *parent, size_t i);

/* A key with nothing behind it, which may stand for an empty map. */
bool node_is_nothing(const struct node *n);

/* A value as it stands in messages: 'its text', a list or a map of keys, an
 * empty list or map of keys. */
struct text_shown node_shown(const struct node *n);

/* NULL is harmless. */
void node_free(struct node *n);

/* Writes one printable line, "FILE:LINE:COL: text" or "--set KEY=VALUE: text",
 * and returns STATUS_BAD_SCENE. */
enum status place_blame(struct place at, struct fault *why, const char *format,
                        ...) __attribute__((format(printf, 3, 4)));
