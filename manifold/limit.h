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

/* Whether dep has none at all: Y d dep/d ind at Y = |ind|, of which dep is the
 * integral over ln Y, does not fall from half of the way there to its end, or
 * far beyond it where ind is no logarithm.  Neither: not told. */
bool limit_is_none(const struct planar *sys, int ind, int toward, double dep);
