/*
 * limit.h -- what it means that a branch has a limit at infinity.
 *
 * Where one coordinate, `ind`, runs and the other one, dep, has all but
 * settled, dep has a limit if the slope d dep/d ind decays exponentially.  Some
 * slopes fall like 1/|ind|, or to a constant, however small: then it has none.
 */
#pragma once

#include "local.h"

/* Looks at the slope along ind = toward * infinity at dep, over the outer half
 * of the way from the origin to the edge of the domain. */
bool limit_exists(const struct planar *sys, int ind, int toward, double dep);
