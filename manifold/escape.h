/*
 * escape.h -- whether an orbit that has left a window can come back.
 *
 * A round about the window, from a place of the ray from its middle to the
 * right to one further out, and the ray from there back, are a closed curve
 * around the window.  Orbits cross it on the ray alone; where all cross it in
 * the sense of the round they come out, and none comes in again.
 */
#pragma once

#include "curve.h"
#include "planar.h"

/* All zero before the first piece. */
struct escape {
    bool outside;     /* since the window was touched last */
    struct vec2 here; /* end of the last piece, from the window's middle, in
                         half sides */
    double at;        /* where it crossed the ray last, in half sides; 0: it did
                         not, or has turned back since */
    double sense;     /* of that crossing: 1, anticlockwise, or -1 */
    bool half;        /* it has crossed the ray to the left since */
    bool left;        /* for good */
};

/* One more piece of a curve of offsets from the system's origin, the window
 * absolute; true where it comes round to the ray. */
bool escape_add(struct escape *e, const struct planar *sys, struct box window,
                const struct curve *c, size_t piece);

/* Whether a piece of a curve of offsets from an origin may touch a box, whose
 * sides may be infinite: between two of its places the curve is nowhere further
 * from both than TOL_ESCAPE_CHORD of their distance, in sides of the box. */
bool escape_may_touch(const struct curve *c, size_t piece, struct vec2 origin,
                      struct box box);

/* A box of offsets: a piece about whose this does not meet a box of that size
 * does not touch it, as the above tells.  Finite. */
struct box escape_around(const struct curve *c, size_t piece, struct vec2 size);
