/* basin_tolerance.h -- the tunable numbers of maps and single states. */
#ifndef BASIN_BASIN_TOLERANCE_H
#define BASIN_BASIN_TOLERANCE_H

#include "slow_tolerance.h"

/* Shares of a window are differences of areas, which round. */
#define TOL_SHARE_ROUNDING 1e-14

#endif
