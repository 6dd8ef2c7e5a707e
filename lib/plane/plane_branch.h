/* plane_branch.h -- the manifolds of all saddles of a plane of formulas, and
 * whereto they go. */
#pragma once

#include "plane_study.h"

/* Fills s->branch, and s->cycle by those they wind on to.  STATUS_NO_MEMORY,
 * STATUS_STOPPED. */
MUST_CHECK enum status plane_branch_grow(struct plane_study *s,
                                         const struct monitor *monitor);

/* Adds the stable manifolds of the saddles outside the window that have none
 * yet.  STATUS_NO_MEMORY. */
MUST_CHECK enum status plane_branch_grow_outside(struct plane_study *s);
