/* keep.h -- where in the axes' box labels must not stand: cells of a grid that
 * curves cross, that marks or other labels cover, or that have no value. */
#pragma once

#include <stdint.h>

#include "layer.h"
#include "stroke.h"

struct keep {
    size_t nx, ny;
    uint8_t *taken; /* owned; 0: free, else by whom */
};

enum { KEEP_ALL = 1, KEEP_OWN }; /* from KEEP_OWN on: a line with labels */

/* For a box of so many pixels; STATUS_NO_MEMORY leaves *k empty. */
MUST_CHECK enum status keep_init(struct keep *k, struct vec2 box);

/* Takes what the stroke crosses, all cells within `half` of a point, those of
 * the map over the box without a value. */
void keep_stroke(struct keep *k, const struct stroke *s, uint8_t by);
void keep_box(struct keep *k, struct vec2 at, struct vec2 half);
void keep_gaps(struct keep *k, const struct figure_raster *r);

/* Whether all within `half` of a point is in the box and taken by none but
 * `by`. */
bool keep_is_free(const struct keep *k, struct vec2 at, struct vec2 half,
                  uint8_t by);

/* A second call is harmless. */
void keep_free(struct keep *k);
