/*
 * spread.h -- places for orbits that fill a window evenly: always the candidate
 * furthest from everything drawn so far, and half as far from the frame, as if
 * the drawing went on beyond it as its mirror image.
 */
#pragma once

#include <stdint.h>

#include "curve.h"
#include "polyline.h"
#include "window.h"

struct spread_candidate {
    struct vec2 unit; /* position in the drawing */
    double gap;       /* squared distance to what is drawn */
};

struct spread {
    const struct window *window;        /* borrowed */
    struct spread_candidate *candidate; /* owned */
    size_t count;
};

/* `count` candidates from a low-discrepancy sequence shifted by `seed`.
 * Deterministic.  STATUS_NO_MEMORY: *s is empty. */
MUST_CHECK enum status spread_init(struct spread *s,
                                   const struct window *window, size_t count,
                                   uint64_t seed);

/* Takes the candidate with the largest gap; the first of equals.  False: none
 * is left. */
bool spread_take(struct spread *s, struct vec2 *z);

/* Whatever comes next keeps away from this curve, whose components 0 and 1
 * are offsets from `origin`. */
void spread_avoid(struct spread *s, const struct curve *c, struct vec2 origin);

/* Nor near these points, unit coordinates, and the straight lines between. */
void spread_avoid_way(struct spread *s, const struct polyline *way);

/* A second call is harmless. */
void spread_free(struct spread *s);
