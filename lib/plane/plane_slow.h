/* plane_slow.h -- where the plane is slow along a branch: equilibria are near.
 */
#pragma once

#include "plane_study.h"

struct plane_slow {
    const struct plane_study *s; /* borrowed, as is the branch; the rest 0 */
    const struct plane_branch *b;
    double speed[3], fastest;
    size_t looks;
};

/* The next place, theta on a piece, where it is slower than beside, and slow
 * (TOL_SEEN) against where it was fastest before; false: there is none. */
bool plane_slow_next(struct plane_slow *w, size_t *piece, double *theta);
