/* plane_border.h -- the curves between the basins of a plane. */
#pragma once

#include "plane_study.h"

/* Cycles that repel, from orbits backward in time: from beside every attractor
 * and cycle, of these numbers or more.  STATUS_NO_MEMORY. */
MUST_CHECK enum status plane_border_look(struct plane_study *s, size_t rests,
                                         size_t cycles);

/* A cycle that repels, from an absolute point backward in time. */
MUST_CHECK enum status plane_border_look_from(struct plane_study *s,
                                              struct vec2 z);

/* Fills s->basin.border and cuts.  STATUS_NO_MEMORY. */
MUST_CHECK enum status plane_border_find(struct plane_study *s);
