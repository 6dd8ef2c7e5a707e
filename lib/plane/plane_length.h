/* plane_length.h -- how much of a branch the window shows, and how long it is.
 */
#pragma once

#include "plane_study.h"

/* Sets shown, shown_to and length; `beyond` is added to the length's bar. */
void plane_length_find(const struct plane_study *s, struct plane_branch *b,
                       double beyond);

/* An absolute point of it, its saddle being at `origin`. */
struct vec2 plane_length_point(const struct plane_branch *b, struct vec2 origin,
                               size_t piece, double theta);
