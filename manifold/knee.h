/* knee.h -- where a branch's slope dy/dx passes through 1. */
#pragma once

#include "branch.h"

enum knee_kind {
    KNEE_RISING,   /* the slope grows through 1, going outward: a knee */
    KNEE_FALLING,  /* it falls through 1 */
    KNEE_UNDECIDED /* it comes so near 1 that its digits do not tell whether it
                      passes through; no place */
};

struct knee {
    enum knee_kind kind;
    struct vec2 z;     /* offset from the saddle */
    struct vec2 error; /* bound on z: the curve's error at that place, and
                          rounding, over how fast the slope changes */
};

/* All of them outward from the saddle, at most `room`; returns how many there
 * are.  `floor`: what the saddle's own place may be off; z is as that is. */
size_t knee_find(const struct planar *sys, const struct branch *b,
                 struct vec2 floor, struct knee knee[], size_t room);
