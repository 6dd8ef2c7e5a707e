/* batch_goal.h -- inside batch.c: whereto pushed states of a system go. */
#pragma once

#include "batch.h"
#include "sweep_point.h"

/* Those of all b->push into f[pushes] at draw i, whose basins the point's study
 * knows (plane_answer.h): fate 0, the reason being the attractor's name; or -1
 * and why there is no such state.  STATUS_NO_MEMORY. */
MUST_CHECK enum status batch_goal_find(const struct batch *b,
                                       const struct sweep_point *p, size_t i,
                                       const struct batch_fates f[]);
