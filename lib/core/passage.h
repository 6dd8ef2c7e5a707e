/*
 * passage.h -- where the last piece of a curve first enters or leaves a box
 * of its (x, y) plane, or a component first passes a value.
 */
#pragma once

#include "curve.h"
#include "plane.h"

/* What passage_* return when it does not happen: beyond every theta. */
#define PASSAGE_NEVER 2.0

/* Each returns the first theta in [0, 1] to the last digit, 0 if it holds at
 * the start already.  Only a dip for less than TOL_PASSAGE_STEP of the piece
 * may be missed, for passage_into one shorter than TOL_PASSAGE_CHORD of the
 * box, whose width must be positive.  Work is bounded (TOL_ORBIT_STEPS)
 * whatever the coefficients. */

/* First inside b, edges included. */
double passage_into(const struct curve *c, struct box b);

/* First outside b, edges excluded. */
double passage_out_of(const struct curve *c, struct box b);

/* First at or beyond value on the side of its sign: u_i >= value > 0 or
 * u_i <= value < 0. */
double passage_beyond(const struct curve *c, size_t i, double value);

/* Distance in the maximum norm from z to b, negative inside. */
double passage_distance(struct box b, struct vec2 z);
