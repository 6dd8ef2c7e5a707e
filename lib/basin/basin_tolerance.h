/* basin_tolerance.h -- the tunable numbers of maps and single states. */
#pragma once

#include "slow_tolerance.h"

/* Shares of a window are differences of areas, which round. */
#define TOL_SHARE_ROUNDING 1e-14
