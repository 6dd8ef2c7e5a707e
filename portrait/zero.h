/*
 * zero.h -- the zero set of one component of a field, asked about by sign.
 *
 * Points are fractions u of the box, u in [0, 1] x [0, 1] inside.  A component
 * that underflows beside a gigantic other one still says where it is going if
 * the system leaves it a signed zero; if it does not, the frontier of the
 * underflow is told from a true zero by looking at both sides.
 */
#pragma once

#include "planar.h"

struct zero {
    const struct planar *system; /* borrowed */
    struct box box;
    int which;    /* 0: direction.x = 0; 1: direction.y = 0 */
    size_t calls; /* of field and jacobian */
};

/* A zero between a and b, to the last digit.  False: both have the same sign,
 * a value is NaN, or the sign changes for lack of digits only. */
bool zero_between(struct zero *q, struct vec2 a, struct vec2 b, struct vec2 *u);

/* Unit tangent of the zero set at its point u (in u coordinates), turned
 * to the side of `along` (of unit length): from the Jacobian, or by looking
 * for the neighbouring zero where the Jacobian has underflowed or vanishes.
 * False: neither knows. */
bool zero_tangent(struct zero *q, struct vec2 u, struct vec2 along,
                  struct vec2 *tangent);

/* Whether signs differ at equal distances *width from u on both sides, along
 * the unit vector `across`: looked for from `narrow` to `reach`, so that a
 * second piece further off does not hide the one near by. */
bool zero_within(struct zero *q, struct vec2 u, struct vec2 across,
                 double narrow, double reach, double *width);

/* The zero between those two points.  False: none found. */
bool zero_near(struct zero *q, struct vec2 u, struct vec2 across, double narrow,
               double reach, struct vec2 *out);
