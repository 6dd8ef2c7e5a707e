/* plane_orbit.h -- whereto orbits of a plane of formulas go. */
#pragma once

#include "plane_study.h"

/* What tells where an orbit goes before it is there, forward in time. */
struct plane_guide {
    struct plane_rounds *rounds; /* borrowed */
    /* whether the goal of an absolute point is known; NULL: of none */
    bool (*knows)(void *ctx, struct vec2 z, struct plane_goal *out);
    void *ctx; /* borrowed */
};

/* Whereto the orbit from an absolute point goes, forward or backward in time.
 * Where it has left the window for good, PLANE_GOAL_LEFT, it ends, unless there
 * is a guide: it is followed to where that knows, or to its end, and rounds
 * that are empty become its own.
 * STATUS_NO_MEMORY. */
MUST_CHECK enum status plane_orbit(const struct plane_study *s, struct vec2 z,
                                   bool backward,
                                   const struct plane_guide *guide,
                                   struct plane_goal *out);
