/* plane_edge.h -- what divides the states that go to different ends, where no
 * curve that is known does: the orbit between them comes by a saddle outside
 * the window, or from a cycle there that repels (edge tracking: Skufca, Yorke &
 * Eckhardt, Phys. Rev. Lett. 96, 174101, 2006). */
#pragma once

#include "plane_label.h"

/* Two absolute points, and whereto they go. */
struct plane_edge {
    struct vec2 z[2];
    struct plane_goal goal[2];
};

/* Halves the line between them down to rounding, each time the part whose ends
 * differ, and follows what is left: adds the saddle that it comes by, or the
 * cycle, to those of the study.  STATUS_NO_MEMORY, or what ask returns. */
MUST_CHECK enum status plane_edge_find(struct plane_study *s,
                                       struct plane_edge *e, plane_ask *ask,
                                       void *ctx);
