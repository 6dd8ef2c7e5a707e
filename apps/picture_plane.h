/* picture_plane.h -- a plane study as a figure, on axes of its states; and one
 * more for each margin (plane_margin.h) that was asked for. */
#ifndef APPS_PICTURE_PLANE_H
#define APPS_PICTURE_PLANE_H

#include "output.h"
#include "plane_study.h"

void picture_plane(const struct plane_study *s, struct panels *out);

#endif
