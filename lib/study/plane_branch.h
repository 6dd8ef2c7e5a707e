/* plane_branch.h -- whereto curves of a plane of formulas go: the manifolds of
 * all its saddles, and orbits. */
#ifndef STUDY_PLANE_BRANCH_H
#define STUDY_PLANE_BRANCH_H

#include "plane_study.h"

/* Fills s->branch, and s->cycle by those they wind on to.  STATUS_NO_MEMORY,
 * STATUS_STOPPED. */
MUST_CHECK enum status plane_branch_grow(struct plane_study *s,
                                         const struct monitor *monitor);

/* Whereto the orbit from an absolute point goes, forward or backward in time.
 * STATUS_NO_MEMORY. */
MUST_CHECK enum status plane_follow(const struct plane_study *s, struct vec2 z,
                                    bool backward, struct plane_goal *out);

#endif
