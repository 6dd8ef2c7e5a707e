/* plane_defined.h -- whether orbits get on all along a curve, by intervals: a
 * step may jump over a pole, or, outside the window, over an equilibrium that
 * is not known. */
#pragma once

#include "interval.h"
#include "plane_study.h"

/* Makes s->plan; s->entire where formulas have values everywhere.
 * STATUS_NO_MEMORY, STATUS_BAD_SCENE. */
MUST_CHECK enum status plane_defined_plan(struct plane_study *s,
                                          struct fault *why);

/* A copy of s->plan, or NULL. */
struct interval_plan *plane_defined_copy(const struct plane_study *s);

enum plane_defined {
    PLANE_DEFINED,
    PLANE_DEFINED_BREAKS, /* formulas have no values there */
    PLANE_DEFINED_RESTS,  /* an equilibrium may be there */
    PLANE_DEFINED_UNKNOWN
};

/* On a piece of a curve of offsets from an origin: they do everywhere, or what
 * there is at theta, or it is too much work to tell. */
enum plane_defined plane_defined_along(struct interval_plan *plan,
                                       const struct plane_study *s,
                                       const struct curve *c, size_t piece,
                                       struct vec2 origin, double *theta);

/* Whether the orbit from an absolute point outside the window is proved to
 * leave all bounds: from there on, within bounds of the other coordinate that
 * it does not cross, or anywhere, one coordinate only goes further out; or a
 * positive state falls to where doubles end before the orbit is out of such
 * bounds, which from there on would take too long for any orbit. */
bool plane_defined_escapes(struct interval_plan *plan,
                           const struct plane_study *s, struct vec2 z,
                           bool backward);

/* At which places of an absolute box. */
enum interval_domain plane_defined_domain(struct interval_plan *plan,
                                          const struct plane_study *s,
                                          struct box b);

/* At all places of a box. */
bool plane_defined_in(struct interval_plan *plan, const struct plane_study *s,
                      struct box b);

/* At all places as near to an absolute point as this part of the window. */
bool plane_defined_near(struct interval_plan *plan, const struct plane_study *s,
                        struct vec2 z, double part);
