/*
 * workprec_curve.h -- the saddle's stable manifold as a curve in 113 bits: how
 * far a point is from it, and where it crosses a row.
 *
 * Backward in time, in arc length of the chart, from 1e-14 of the saddle on its
 * eigenvector (the curve is as near a straight line there as 113 bits can
 * tell, and attracts), by quad_step.  Knots are kept; between them the curve is
 * followed once more, as a graph, to where it is asked for.
 */
#ifndef RACE_WORKPREC_CURVE_H
#define RACE_WORKPREC_CURVE_H

#include <stddef.h>

#include "plane.h"
#include "quad_block.h"
#include "status.h"

struct workprec_knot {
    quad z[2]; /* offset from the saddle at->x0, at->y0 */
    quad n[2]; /* unit tangent, outward */
};

struct workprec_curve {
    const struct law *law;        /* borrowed */
    const struct quad_anchor *at; /* borrowed */
    struct workprec_knot *knot;   /* owned; outward */
    size_t count, room;
};

/* The branch v > v_0 (side +1) or v < v_0 (-1), to the first knot outside the
 * box of offsets.  STATUS_NO_CONVERGENCE: no saddle, or the curve cannot be
 * followed; STATUS_NO_MEMORY; *c is then empty. */
MUST_CHECK enum status workprec_curve_grow(const struct law *law,
                                           const struct quad_anchor *at,
                                           int side, struct box reach,
                                           struct workprec_curve *c);

/* The distance of the offset z, to first order in it; infinite where no knot is
 * near. */
double workprec_curve_distance(const struct workprec_curve *c, const quad z[2]);

/* x of the curve's first crossing of the row y, both offsets, between knots
 * `before` and before + 1. */
quad workprec_curve_cross(const struct workprec_curve *c, size_t before,
                          quad y);

/* A second call is harmless. */
void workprec_curve_free(struct workprec_curve *c);

#endif
