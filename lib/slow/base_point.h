/*
 * base_point.h -- a state as a point of the slow curve (slow_curve.h): the one
 * that arrives when it does.
 *
 * All of a state's slip and time but a little slip on its way to the curve are
 * those of its base point, functions of one coordinate, tabulated.  The base
 * point itself is smooth as a function of the state where slip and time are
 * not: on the separatrix, which is y = 0, and where orbits pass a node's box of
 * arrest on either side.
 */
#pragma once

#include "fast_layer.h"

struct base_point {
    double y, y_error;       /* offset; NaN: there is none */
    double more, more_error; /* slip beyond that of y, units of L */
    double late; /* how many times as near to a node the curve comes, or to the
                    reach of its box, while the state still falls; <= 1: none */
};

/* Of what has been followed `through` (fast_layer.h). */
struct base_point base_point_of(const struct slow_curve *c,
                                const struct layer *l);

/* What a state of that base point has to come: fate, time, slip, x_end, and
 * the errors of time and slip, which grow like y_error over the distance from
 * the separatrix.  False: not to be relied on, for a state so near may be on
 * either side of that, or pass a box of arrest; of no point of the curve
 * nothing is said but FATE_UNDECIDED. */
bool base_point_tell(const struct slow_curve *c, const struct base_point *b,
                     struct layer *out);

/* Whether base points next to y may pass a box of arrest, or between the two.
 */
bool base_point_passes(const struct slow_curve *c, double one, double other);
