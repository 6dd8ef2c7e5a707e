/* plane_weak.h -- where rounding decides which way an orbit goes on: near
 * equilibria that are not hyperbolic, and near where some may be that are not
 * told apart. */
#pragma once

#include "plane_study.h"

/* Whether an absolute point is within `near`, in sides of the window, of one;
 * a box counts as the disc around it. */
bool plane_weak_at(const struct plane_study *s, struct vec2 z, double near);

/* Whether a piece of a curve of offsets from an origin comes so near, and where
 * first, about: a step may jump over what no orbit passes. */
bool plane_weak_along(const struct plane_study *s, const struct curve *c,
                      size_t piece, struct vec2 origin, double near,
                      double *theta);
