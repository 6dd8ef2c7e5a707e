/* plane_defined.h -- whether a plane's formulas have values all along a curve,
 * by intervals: a step may jump over a pole. */
#ifndef STUDY_PLANE_DEFINED_H
#define STUDY_PLANE_DEFINED_H

#include "interval.h"
#include "plane_study.h"

/* Makes s->plan; s->entire where formulas have values everywhere.
 * STATUS_NO_MEMORY, STATUS_BAD_SCENE. */
MUST_CHECK enum status plane_defined_plan(struct plane_study *s,
                                          struct fault *why);

/* A copy of s->plan, or NULL where s->entire, or no memory. */
struct interval_plan *plane_defined_copy(const struct plane_study *s);

enum plane_defined {
    PLANE_DEFINED,
    PLANE_DEFINED_UP_TO,
    PLANE_DEFINED_UNKNOWN
};

/* On a piece of a curve of offsets from an origin: everywhere, up to theta, or
 * too much work to tell.  Everywhere, where there is no plan. */
enum plane_defined plane_defined_along(struct interval_plan *plan,
                                       const struct plane_study *s,
                                       const struct curve *c, size_t piece,
                                       struct vec2 origin, double *theta);

/* Whether orbits get on all along it, outside the window: that no equilibrium
 * is there is proved. */
bool plane_defined_moves(struct interval_plan *plan,
                         const struct plane_study *s, const struct curve *c,
                         size_t piece, struct vec2 origin);

/* At all places of a box. */
bool plane_defined_in(struct interval_plan *plan, const struct plane_study *s,
                      struct box b);

/* At all places as near to an absolute point as rounding. */
bool plane_defined_near(struct interval_plan *plan, const struct plane_study *s,
                        struct vec2 z);

#endif
