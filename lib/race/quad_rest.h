/* quad_rest.h -- the slip that is left to a block that only fades, and the time
 * and slip that are left to one that stops. */
#pragma once

#include "quad_course.h"

enum quad_left { QUAD_LEFT_TIME, QUAD_LEFT_SLIP };

/* From where the orbit is, to v = 0, with an absolute bound of its error; false
 * where friction does not balance the slope there, or time (slip) has no limit
 * that can be seen. */
bool quad_rest_left(const struct quad_course *c, enum quad_left what,
                    quad *left, quad *error);

/* Adds the slip that is left of one that fades; left[1] is its error, infinite
 * with false where it is not known. */
bool quad_rest_fade(struct quad_course *c, bool has_slip);
