/* plane_answer.h -- whereto one state of a plane goes. */
#pragma once

#include "plane_study.h"

struct plane_answer {
    const char *attractor;   /* a name of the basins */
    struct quantity kick[2]; /* plane_margin.h */
    double stays; /* where parameters scatter: lib/ensemble/goal_scatter.h; NaN:
                     nobody asked, or not known */
};

/* Inside the window by the map of basins, in which a state may lie too near to
 * a boundary to tell; beyond it, and in regions whose boundaries are not known,
 * by the state's own orbit.  The basins are
 * known; state[] as the formulas have it, finite, > 0 where it is positive.
 * STATUS_NO_MEMORY. */
MUST_CHECK enum status plane_answer_at(const struct plane_study *s,
                                       const double state[2],
                                       struct plane_answer *out);
