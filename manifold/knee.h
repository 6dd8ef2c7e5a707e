/* knee.h -- where a branch's slope dy/dx passes through 1. */
#ifndef MANIFOLD_KNEE_H
#define MANIFOLD_KNEE_H

#include "branch.h"

struct knee {
    struct vec2 z;     /* offset from the saddle */
    struct vec2 error; /* bound on z: two routes' difference and rounding */
    bool rising;       /* the slope grows through 1, going outward */
};

/* All crossings of slope 1 outward from the saddle, at most `room`; returns
 * how many there are. */
size_t knee_find(const struct planar *sys, const struct branch *b,
                 struct knee knee[], size_t room);

#endif
