/* plane_margin.h -- how far the states of a plane are from another fate, along
 * rows and along columns of the window. */
#pragma once

#include "plane_study.h"

/* The smallest change of x alone, and of y alone, after which an absolute point
 * of the window goes elsewhere: what is added, or of a positive state the
 * factor; the basins are known.  STATUS_NO_MEMORY. */
MUST_CHECK enum status plane_margin_at(const struct plane_study *s,
                                       struct vec2 z, struct quantity kick[2]);

/* The same of the cells of a grid over the window, row by row, in the chart:
 * the logarithm of a factor; NaN where there is none. */
struct plane_margins {
    double by[2];
};
MUST_CHECK enum status plane_margin_fill(const struct plane_study *s,
                                         size_t columns, size_t rows,
                                         size_t first, size_t count,
                                         struct plane_margins out[]);
