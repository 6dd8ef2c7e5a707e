/* plane_label.h -- which attractor each region of a plane goes to: the
 * equilibria that attract, what is beyond the window, the cycles that attract,
 * in this order. */
#pragma once

#include "plane_patch.h"

/* Labels all regions, whose areas are known; fills s->beyond, and adds cycles
 * that are new.  STATUS_NO_MEMORY, STATUS_STOPPED. */
MUST_CHECK enum status plane_label_all(struct plane_study *s, struct patches *p,
                                       const struct monitor *monitor);

/* The label of a goal; -1: it has none. */
int8_t plane_label_of(const struct plane_study *s,
                      const struct plane_goal *goal);

/* The label of s->beyond[0]; the others follow. */
size_t plane_label_beyond(const struct plane_study *s);

/* Whether the goal is what the label says, as far as both are known. */
bool plane_label_allows(const struct plane_study *s, int8_t label,
                        const struct plane_goal *goal);
