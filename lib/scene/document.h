/* document.h -- YAML text made into a tree of nodes.
 *
 * A scene is plain data: one document, without anchors, aliases and tags, its
 * keys words that are given once.  What else is wrong in a text, to its bytes,
 * is refused in one line. */
#pragma once

#include "node.h"

/* A whole document of keys and values; an empty one is an empty map.  The text
 * ends in a zero after its `size` bytes; `name` (NULL: no file) stands in
 * messages and must outlive the tree.
 *
 * STATUS_BAD_SCENE with one line in *why, STATUS_NO_MEMORY; *out is untouched
 * then, else owned by the caller. */
MUST_CHECK enum status document_read(const char *text, size_t size,
                                     const char *name, struct node **out,
                                     struct fault *why);

/* The VALUE of "KEY=VALUE", of whatever kind; `set` must hold a '=' and
 * outlive the tree.  Errors as above. */
MUST_CHECK enum status document_read_set(const char *set, struct node **out,
                                         struct fault *why);
