/* picture_plane.h -- a plane study as a figure, on axes of its states. */
#ifndef APPS_PICTURE_PLANE_H
#define APPS_PICTURE_PLANE_H

#include "output.h"
#include "plane_study.h"

void picture_plane(const struct plane_study *s, struct figure *figure);

#endif
