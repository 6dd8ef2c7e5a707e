/*
 * region.h -- the regions into which separatrices divide the plane.
 *
 * Between the ends of strands, and flat stretches, their order along a row does
 * not change, for stable manifolds do not cross: a `band` of rows, in which
 * regions are counted from the left.  One basin may consist of several regions.
 */
#pragma once

#include <stdint.h>

#include "separatrix.h"

struct region {
    int8_t label; /* REGION_UNLABELLED until somebody sets it */
};
enum { REGION_UNLABELLED = -2 };

struct band {
    double lo, hi;         /* rows lo <= y < hi; may be infinite */
    size_t strands, first; /* regions number first .. first + strands */
};

struct regions {
    const struct separatrix *separatrix; /* borrowed; along y */
    struct band *band;                   /* owned; from below */
    size_t bands;
    struct region *region; /* owned */
    size_t count;
    size_t most; /* strands in any band */
};

/* STATUS_BAD_ARGUMENT: not along y; STATUS_NO_MEMORY.  On error *r is empty. */
MUST_CHECK enum status regions_init(struct regions *r,
                                    const struct separatrix *separatrix);

const struct band *regions_band(const struct regions *r, double y);

/* The number of the region of an absolute point; c has room for most + 1. */
size_t regions_at(const struct regions *r, struct vec2 z, struct crossing c[]);

/* An area and a bound of its error. */
struct area {
    double value, error;
};

/* The area of every region within a finite box: out[r->count]; c as above. */
void regions_areas(const struct regions *r, struct box w, struct measure m,
                   struct crossing c[], struct area out[]);

/* A second call is harmless. */
void regions_free(struct regions *r);
