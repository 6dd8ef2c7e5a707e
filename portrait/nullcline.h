/*
 * nullcline.h -- the curves in a window on which x' = 0, and on which y' = 0.
 *
 * The signs of both components are looked at on a grid; every change of sign
 * between neighbours gives a point, and from each point not yet passed the
 * curve is followed both ways.  Found are all pieces that separate two points
 * of the grid: closed loops smaller than a cell of TOL_NULLCLINE_CELLS a side
 * and pieces nearer to each other than a cell may be missed, as are zeros of
 * even order, where nothing changes sign, and a piece that is the window's
 * edge itself.
 */
#pragma once

#include "polyline.h"
#include "window.h"

enum { NULLCLINE_X, NULLCLINE_Y, NULLCLINES }; /* x' = 0; y' = 0 */

/* Pieces in absolute chart coordinates.  Points are on the zero set up to the
 * rounding of the coordinates; a closed piece ends where it starts, an open
 * one starts and ends exactly on the window's edge. */
struct nullcline {
    struct polyline *piece; /* owned; >= 2 points each */
    size_t count, room;
    size_t loose; /* ends inside the window: at a cusp, or where the component
                     underflows so far that its sign is lost */
    size_t evaluations; /* of the field or its Jacobian; of those on the grid
                           each component counts half */
};

#define NULLCLINE_EMPTY ((struct nullcline){ .count = 0 })

/* Both nullclines; `chord`: how far the straight line between neighbouring
 * points may be from the curve, as a fraction of the drawing's sides.  A window
 * without zeros has no pieces. STATUS_BAD_ARGUMENT: window outside the domain
 * or chord <= 0; STATUS_NO_MEMORY.  On error *out is untouched. */
MUST_CHECK enum status nullcline_find(const struct planar *system,
                                      const struct window *window, double chord,
                                      struct nullcline out[NULLCLINES]);

/* Leaves *n empty, so a second call is harmless. */
void nullcline_free(struct nullcline *n);
