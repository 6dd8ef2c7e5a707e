/* plane_label.h -- which attractor each region of a plane goes to. */
#pragma once

#include "plane_goal.h"
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
