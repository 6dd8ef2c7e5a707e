/*
 * plane_parts.h -- poles, and the edges of where formulas have values, part
 * states that no curve of the borders does: an orbit speaks for those to which
 * boxes link it over which intervals show that formulas have values everywhere
 * (or nowhere).  These are the cells of a raster, TOL_PLANE_CELL of the window
 * wide; a part is what cells of one patch and one kind that share a side make
 * up.  Less of a patch than a cell is wide may be beyond a pole unseen.
 */
#pragma once

#include "plane_patch.h"

struct plane_parts {
    size_t n;       /* cells a side; 0: formulas have values everywhere */
    size_t *part;   /* owned; by cell: the first cell of its part, or n^2 */
    size_t *patch;  /* owned; by cell; or the number of regions */
    size_t *middle; /* owned; by first cell: the middle of its longest row */
    bool *several;  /* owned; by patch: it has more parts than one */
};

/* STATUS_NO_MEMORY: *out is empty.  p->of is known. */
MUST_CHECK enum status plane_parts_find(const struct patches *p,
                                        struct plane_parts *out);

/* Whether a cell is the first of one of several parts of a patch; *z: an
 * absolute point inside that. */
bool plane_parts_place(const struct plane_parts *p, const struct plane_study *s,
                       size_t cell, struct vec2 *z);

/* Whether an absolute box meets two parts of a patch. */
bool plane_parts_divide(const struct plane_parts *p,
                        const struct plane_study *s, size_t patch,
                        struct box b);

/* A second call is harmless. */
void plane_parts_free(struct plane_parts *p);
