/* picture_plane.h -- a plane study as a figure, on axes of its states; and one
 * more for each margin (plane_margin.h) that was asked for. */
#pragma once

#include "output.h"
#include "plane_study.h"

/* What equilibria are called in legends, and their marks. */
struct picture_plane_look {
    const char *entry;
    enum figure_mark mark;
};
extern const struct picture_plane_look picture_plane_look[PLANE_TYPES];

void picture_plane(const struct plane_study *s, struct panels *out);
