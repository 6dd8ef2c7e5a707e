/* plane_goal.h -- whereto orbits go, and their labels: the equilibria that
 * attract, what is beyond the window, the cycles that attract, in this order.
 */
#pragma once

#include "plane_study.h"

/* Whether two goals may be one. */
bool plane_goal_is_same(const struct plane_study *s, const struct plane_goal *a,
                        const struct plane_goal *b);

/* The label of a goal; -1: it has none. */
int8_t plane_goal_label(const struct plane_study *s,
                        const struct plane_goal *goal);

/* The label of s->beyond[0]; the others follow. */
size_t plane_goal_beyond(const struct plane_study *s);

/* Whether the goal is what the label says, as far as both are known. */
bool plane_goal_allows(const struct plane_study *s, int8_t label,
                       const struct plane_goal *goal);

/* Whether both are one; *a then is what is known of it. */
bool plane_goal_meet(const struct plane_study *s, struct plane_goal *a,
                     const struct plane_goal *b);
