/* contour.h -- lines along which a map has one value. */
#pragma once

#include "keep.h"
#include "layer.h"
#include "stroke.h"

/* The lines of the map at this level, in pixels of the axes' box, between the
 * centres of cells: none where a neighbour has no value, or another by a sixth
 * of the scale.  *out is emptied first, also on STATUS_NO_MEMORY. */
MUST_CHECK enum status contour_trace(const struct figure_raster *r,
                                     double level, struct vec2 box,
                                     struct stroke *out);

/* Where a text of this size may stand on them, with so many px around it: on
 * the longest piece, where all is free but for the lines themselves.  False:
 * nowhere. */
enum { CONTOUR_CLEAR = 5 };
bool contour_place(const struct stroke *s, struct vec2 size,
                   const struct keep *keep, uint8_t own, struct vec2 *at);
