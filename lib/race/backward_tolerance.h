/* backward_tolerance.h -- the tunable numbers of the second route. */
#pragma once

#include "tolerance.h"

/* Offsets from the saddle are in units of where the orbit was, until they have
 * grown by this: its errors are then carried by gradients that compare, and
 * stay far from where squares overflow. */
#define TOL_BACKWARD_UNITS 0x1p10
/* A branch has ended when what is left is below TOL_LITTLE of rtol, so that
 * the end never dominates the error; at the edge of the domain, which is only
 * where doubles end, TOL_SEEN will do (TOL_LIMIT_DECAY tells whether it ends).
 * One without a limit is left where its slope is slight, TOL_DRAWN, and is so
 * TOL_NEARBY ahead of it. */
/* Strides along the asymptote, as a part of the way there: as a power of it,
 * slopes then change by little. */
#define TOL_BACKWARD_STRIDE 0.05
