/* streamline.h -- where an orbit came from, as the drawing shows it. */
#pragma once

#include "polyline.h"
#include "window.h"

/* The orbit through z, inside the window, backward in time: appends its points,
 * unit coordinates of window.h, from z on to the window's edge, exactly, where
 * it came in; or to where it can be followed no further, as beside an
 * equilibrium, or has gone TOL_STREAMLINE_LENGTH sides.  As accurate as a
 * drawing needs, TOL_DRAWN a step; *evaluations of the field are added.
 * STATUS_NO_MEMORY: the points so far are valid. */
MUST_CHECK enum status streamline_back(const struct planar *system,
                                       const struct window *window,
                                       struct vec2 z, struct polyline *way,
                                       size_t *evaluations);
