/* quad_rest.h -- the slip that is left to a block that only fades. */
#ifndef RACE_QUAD_REST_H
#define RACE_QUAD_REST_H

#include "quad_course.h"

/* From where the orbit is, to v = 0, with an absolute bound of its error; false
 * where friction does not balance the slope there, or slip has no limit that
 * can be seen. */
bool quad_rest_left(const struct quad_course *c, quad *slip, quad *error);

#endif
