/* plane_branch.h -- the manifolds of all saddles of a plane of formulas, and
 * whereto they go. */
#pragma once

#include "plane_study.h"

/* Fills s->branch, and s->cycle by those they wind on to.  STATUS_NO_MEMORY,
 * STATUS_STOPPED. */
MUST_CHECK enum status plane_branch_grow(struct plane_study *s,
                                         const struct monitor *monitor);
