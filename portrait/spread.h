/*
 * spread.h -- starts for trajectories that fill a window evenly: always the
 * candidate furthest from everything drawn so far.
 */
#ifndef PORTRAIT_SPREAD_H
#define PORTRAIT_SPREAD_H

#include <stdint.h>

#include "curve.h"
#include "window.h"

enum spread_place {
    SPREAD_EDGE,     /* on the window's edge, where the field points inward */
    SPREAD_INTERIOR, /* anywhere */
    SPREAD_PLACES
};

struct spread_candidate {
    struct vec2 z;    /* absolute */
    struct vec2 unit; /* position in the drawing */
    double gap;       /* squared distance to what is drawn; inf: nothing */
};

struct spread {
    const struct window *window;                       /* borrowed */
    struct spread_candidate *candidate[SPREAD_PLACES]; /* owned */
    size_t count[SPREAD_PLACES];
};

/* `count` candidates inside, from a low-discrepancy sequence shifted by
 * `seed`, and as many around the edge, of which those are kept where the field
 * points inward.  Deterministic.  STATUS_NO_MEMORY: *s is empty. */
MUST_CHECK enum status spread_init(struct spread *s,
                                   const struct planar *system,
                                   const struct window *window, size_t count,
                                   uint64_t seed);

/* Takes the candidate with the largest gap; the first of equals.  False: none
 * is left. */
bool spread_take(struct spread *s, enum spread_place place, struct vec2 *z);

/* Whatever comes next keeps away from this curve, whose components 0 and 1
 * are offsets from `origin`. */
void spread_avoid(struct spread *s, const struct curve *c, struct vec2 origin);

/* A second call is harmless. */
void spread_free(struct spread *s);

#endif
