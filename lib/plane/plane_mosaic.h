/*
 * plane_mosaic.h -- a region within which orbits go to different attractors,
 * as between separatrices that are not known, in cells: squares of (s, t), t
 * from its lowest row in the window to its highest, s on each row from its left
 * end to its right one, both evenly in the drawing.
 *
 * A cell has a goal if the middles of it and of its neighbours all have that,
 * or the equilibria that attract in them, and it lies in one part
 * (plane_parts.h) of its patch, and else is parted into four, as far as they
 * are larger than TOL_PLANE_CELL: a border that bends no more sharply than
 * cells are wide does not go unseen.
 */
#pragma once

#include "plane_label.h"
#include "plane_parts.h"

/* Adds the mosaic of a region, which is `part` of the window; its labels are
 * those of s->basin.goal; no orbits more once those of the basins have taken
 * `most` steps.  STATUS_NO_MEMORY, or what ask returns. */
MUST_CHECK enum status plane_mosaic_add(
    struct plane_study *s, struct patches *p, const struct plane_parts *parts,
    size_t region, double part, int64_t most, plane_ask *ask, void *ctx);

/* From numbers of s->basin.goal to labels (plane_label.h), when all are known.
 */
void plane_mosaic_name(struct plane_study *s);

/* The label of a region at an absolute point of it, c being the crossings of
 * its row; -1: it is not known there. */
int8_t plane_mosaic_at(const struct plane_study *s, size_t region,
                       struct vec2 z, const struct crossing c[]);

/* Adds the areas of the cells of mosaic k to sum[label], or to sum[others]
 * where they have none. */
void plane_mosaic_areas(const struct plane_study *s, struct patches *p,
                        size_t k, struct measure m, struct area sum[],
                        size_t others);
