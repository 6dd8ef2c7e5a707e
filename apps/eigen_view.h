/* eigen_view.h -- the axes of Fig 11(a), X and Y of (36) around the saddle:
 * what a drawing along the eigenvectors shows, and the states of its cells. */
#pragma once

#include "study.h"

struct eigen_view {
    struct mat2 basis; /* eigenvectors as columns, both with x-component 1 */
    double reach;      /* |X|, |Y| on the axes: both critical velocities */
};

/* Of a study whose slope has a saddle. */
struct eigen_view eigen_view_of(const struct study *s);

/* The middles of columns x rows cells, upward row by row, as offsets from the
 * saddle in the chart.  Owned by the caller; NULL: no memory. */
struct vec2 *eigen_view_states(const struct eigen_view *e, size_t columns,
                               size_t rows);

/* The fates (enum fate) of n such states.  STATUS_NO_MEMORY. */
MUST_CHECK enum status eigen_view_labels(const struct study *s,
                                         const struct vec2 z[], size_t n,
                                         int8_t label[]);
