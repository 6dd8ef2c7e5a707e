/* picture_field.h -- a field of the cells (cells.h) as an image. */
#pragma once

#include "figure.h"
#include "study.h"
#include "unit.h"

/* The axes of Fig 11(a), X and Y of (36) around the saddle: what a drawing
 * along the eigenvectors shows, and the states of its cells. */
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

/* The cells behind the pictures, no finer than the study's grid. */
struct picture_raster {
    struct cell *cell; /* owned */
    size_t columns, rows;
};

/* Of the scene's window, or of a view along eigenvectors.  STATUS_NO_MEMORY,
 * STATUS_STOPPED: *r is to be freed in any case. */
MUST_CHECK enum status picture_raster_find(struct picture_raster *r,
                                           const struct study *s,
                                           const struct eigen_view *view,
                                           const struct monitor *monitor);

/* A second call is harmless. */
void picture_raster_free(struct picture_raster *r);

void picture_add_field(const struct picture_raster *r, enum cell_field field,
                       const struct unit_system *units, struct figure *f);

/* How far every state is from another fate: a factor on v or on psi, or a shift
 * of psi where it is a logarithm and told as it is. */
void picture_add_margin(const struct study *s, const struct eigen_view *view,
                        enum basin_axis axis, struct figure *f);
const char *picture_margin_panel(enum basin_axis axis);

/* "_slip": what its file is named after (output.h). */
const char *picture_field_panel(enum cell_field field);
