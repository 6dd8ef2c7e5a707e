/* plane_map.h -- where a state is among the basins of a window. */
#pragma once

#include "plane_study.h"

/* Whether an absolute point may lie on a curve that divides. */
bool plane_map_is_near(const struct plane_study *s, struct vec2 z);

/* The label, a number of s->basin.share, of an absolute point; below 0 where it
 * may lie on a boundary or is not known, or where only its cell
 * (plane_mosaic.h) has one, unless cells. */
MUST_CHECK enum status plane_map_at(const struct plane_study *s, struct vec2 z,
                                    bool cells, int8_t *label);

/* Rows of the grid of the scene, or of another one over the window, where cells
 * are even in the drawing. */
MUST_CHECK enum status plane_map_fill(const struct plane_study *s,
                                      size_t columns, size_t rows, size_t first,
                                      size_t count, int8_t out[]);

/* Column or row i of n, as a state and (chart) as a coordinate. */
double plane_map_cell(const struct plane_study *s, int axis, size_t i, size_t n,
                      bool chart);
