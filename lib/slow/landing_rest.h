/*
 * landing_rest.h -- an orbit on its way onto the curve along which the block
 * comes to rest (rest_curve.h), where psi settles and v does not.
 */
#pragma once

#include "landing.h"

/* As landing_is_over; *most is made smaller where it is too far. */
bool landing_rests(struct landing *l, double *most);
