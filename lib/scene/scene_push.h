/* scene_push.h -- the pushes of an ensemble: states, or what is added to an
 * equilibrium's. */
#pragma once

#include "scene_vary.h"

/* Reader of schema.h. */
VALUE_READER(value_pushes);

/* Their units, which only the whole tree tells; of a law.  Errors as
 * scene_read. */
MUST_CHECK enum status scene_push_settle(const struct node *root,
                                         struct scene *s, struct fault *why);
