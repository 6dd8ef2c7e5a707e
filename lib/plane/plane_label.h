/* plane_label.h -- which attractor each region of a plane goes to: the
 * equilibria that attract, what is beyond the window, the cycles that attract,
 * in this order. */
#pragma once

#include "plane_patch.h"

/* Labels all regions, whose areas are known; fills s->beyond, and adds cycles
 * that are new, and equilibria outside the window that orbits go to.  *news:
 * there are new borders instead (plane_edge.h), by which the window is to be
 * cut anew.  STATUS_NO_MEMORY, STATUS_STOPPED. */
MUST_CHECK enum status plane_label_all(struct plane_study *s, struct patches *p,
                                       const struct monitor *monitor,
                                       bool *news);

/* Whereto an absolute point goes. */
typedef enum status plane_ask(void *ctx, struct vec2 z,
                              struct plane_goal *goal);

/* Whether two goals may be one. */
bool plane_label_is_same(const struct plane_study *s,
                         const struct plane_goal *a,
                         const struct plane_goal *b);

/* The label of a goal; -1: it has none. */
int8_t plane_label_of(const struct plane_study *s,
                      const struct plane_goal *goal);

/* The label of s->beyond[0]; the others follow. */
size_t plane_label_beyond(const struct plane_study *s);

/* Whether the goal is what the label says, as far as both are known. */
bool plane_label_allows(const struct plane_study *s, int8_t label,
                        const struct plane_goal *goal);
