/* plane_patch.h -- which regions (region.h) are one: neighbouring bands share a
 * part of the row between them. */
#pragma once

#include "plane_study.h"

/* Regions and which belong together: of[i] <= i, of[i] == i for the first. */
struct patches {
    struct plane_study *s;
    struct regions *r;
    size_t *of;
    bool *alone; /* small, and formulas may have no values in it: it is joined
                    to no other, and no orbit speaks for it */
    struct area *area, *part; /* in the window, and in a part of it */
    struct plane_goal *goal;  /* of the first regions */
    struct crossing *below, *above, *before;
};

/* The first region of the patch that region i belongs to. */
size_t plane_patch_of(const struct patches *p, size_t i);

/* The band that holds a region. */
const struct band *plane_patch_band(const struct regions *r, size_t region);

/* The left and the right end of region k between n crossings, in the window. */
double plane_patch_end(const struct plane_study *s, const struct crossing c[],
                       size_t n, size_t k);

/* Thin bands are none: a curve ends before what it goes to. */
bool plane_patch_is_door(const struct plane_study *s, const struct band *band);

/* Fills p->of and p->alone; areas are known.  STATUS_NO_MEMORY. */
MUST_CHECK enum status plane_patch_join(struct patches *p);

/* How many steps of orbits take as long as to find the crossings of rows. */
int64_t plane_patch_work(const struct patches *p, int rows);

/* An absolute point inside a region, on the row where it is widest of some;
 * false: it is nowhere wide. */
bool plane_patch_place(const struct patches *p, size_t region, struct vec2 *z);

/* A patch, its area, and its largest region. */
struct patch_whole {
    size_t patch, largest;
    double area;
};

/* Of all patches, the largest first: p->r->count of them, those that are no
 * first regions without area; returns the area of all.  In a thin band a curve
 * may end: what lies beside it there is not known, and its regions have no
 * area, nor those whose bar it is within. */
double plane_patch_sort(const struct patches *p, struct patch_whole w[]);
