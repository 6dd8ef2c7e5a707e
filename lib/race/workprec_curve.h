/*
 * workprec_curve.h -- the saddle's stable manifold as a curve in 113 bits: how
 * far a point is from it, and where it crosses a row.  From points of the
 * branch (quad_branch.h) it is followed once more, as a graph, to where it is
 * asked for.
 */
#pragma once

#include "quad_branch.h"

/* The unit tangent at the offset z, outward. */
void workprec_curve_tangent(const struct quad_branch *c, const quad z[2],
                            quad n[2]);

/* The distance of the offset z, to first order in it; infinite where the curve
 * is not above, below or beside it. */
double workprec_curve_distance(const struct quad_branch *c, const quad z[2]);

/* x of the curve's first crossing of the row y, both offsets, between points
 * `before` and before + 1 of the branch. */
quad workprec_curve_cross(const struct quad_branch *c, size_t before, quad y);
