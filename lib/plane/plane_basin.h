/*
 * plane_basin.h -- whereto the states of a window go: regions between the
 * stable manifolds of all saddles and the cycles that repel, each labelled by
 * orbits, and the share of each attractor.
 */
#pragma once

#include "plane_study.h"

/* Fills s->basin; the branches are known.  STATUS_NO_MEMORY, STATUS_STOPPED;
 * STATUS_BAD_SCENE: more than INT8_MAX attractors, labels are bytes. */
MUST_CHECK enum status plane_basin_find(struct plane_study *s,
                                        const struct monitor *monitor);

/* Whether an absolute point may lie on a curve that divides. */
bool plane_basin_is_near(const struct plane_study *s, struct vec2 z);

/* The label, a number of s->basin.share, of an absolute point; below 0 where it
 * may lie on a boundary or is not known, or where only its cell
 * (plane_mosaic.h) has one, unless cells. */
MUST_CHECK enum status plane_basin_at(const struct plane_study *s,
                                      struct vec2 z, bool cells, int8_t *label);

/* Rows of the grid of the scene, or of another one over the window, where cells
 * are even in the drawing. */
MUST_CHECK enum status plane_basin_fill(const struct plane_study *s,
                                        size_t columns, size_t rows,
                                        size_t first, size_t count,
                                        int8_t out[]);

/* Column or row i of n, as a state and (chart) as a coordinate. */
double plane_basin_cell(const struct plane_study *s, int axis, size_t i,
                        size_t n, bool chart);

/* A second call is harmless. */
void plane_basin_free(struct plane_basin *b);
