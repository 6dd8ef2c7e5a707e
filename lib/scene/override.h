/* override.h -- sets one key of a tree: --set KEY=VALUE. */
#pragma once

#include "node.h"

/* Puts VALUE, read as YAML, at KEY, a dotted path of the schema, e.g.
 * "window.v=[1e-3, 1e3]", in place of what is there and of what excludes it:
 * slope.alpha takes slope.alpha_deg out, law.preset the components of a law.
 * `set` must outlive the tree.
 *
 * STATUS_BAD_SCENE with one line in *why, which begins with --set KEY=VALUE:
 * or, where a value of the tree stands in place of keys, with that one's
 * FILE:LINE:COL:; STATUS_NO_MEMORY.  The tree may then lack what the key
 * excludes. */
MUST_CHECK enum status override_apply(struct node *root, const char *set,
                                      struct fault *why);
