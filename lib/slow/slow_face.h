/*
 * slow_face.h -- how well it is known when an orbit meets the face of a node's
 * box of arrest.
 */
#pragma once

#include "plane.h"

struct slider;

/* The offset z lies on a face of the box around the nearest node, where the
 * orbit has the slope dx/dy: how far off in y, at most, it meets that face. */
double slow_face_error(const struct slider *s, struct vec2 z, double slope);
