/*
 * window.h -- the part of the plane that is drawn, and how each axis is.
 *
 * Coordinates of points are those of the chart, absolute.  An axis shows its
 * coordinate c evenly, or exp(c) evenly: what a caller whose coordinate is the
 * logarithm of something wants when that is to be drawn on a linear axis.
 * `Unit` coordinates are positions in the drawing, [0, 1] x [0, 1].
 */
#pragma once

#include "planar.h"
#include "status.h"

struct window {
    struct box box;      /* lo < hi */
    bool exponential[2]; /* the x axis, y axis shows exp(coordinate) */
};

/* STATUS_BAD_ARGUMENT unless lo < hi, all inside the system's domain. */
MUST_CHECK enum status window_check(const struct window *w,
                                    const struct planar *system);

/* Position in the drawing; and back, exactly on the edges. */
struct vec2 window_unit(const struct window *w, struct vec2 z);
struct vec2 window_at(const struct window *w, struct vec2 unit);

/* A direction at z as it looks in the drawing. */
struct vec2 window_push(const struct window *w, struct vec2 z,
                        struct vec2 direction);

/* The box grown on every side by a fraction of its sides, cut at the domain. */
struct box window_enlarged(const struct window *w, const struct planar *system,
                           double fraction);

/* A point lo + u (hi - lo), exact for u = 0 and 1. */
static inline struct vec2 window_mix(struct box b, struct vec2 u)
{
    return (struct vec2){ (1.0 - u.x) * b.lo.x + u.x * b.hi.x,
                          (1.0 - u.y) * b.lo.y + u.y * b.hi.y };
}
