/* sweep_tolerance.h -- the tunable numbers of sweeps. */
#ifndef SWEEP_SWEEP_TOLERANCE_H
#define SWEEP_SWEEP_TOLERANCE_H

#include "study_tolerance.h"

/* Sweeps (sweep.c).  Halvings of a span: next to a fold 2^-48 of it is as near
 * as the rounding of the key lets one come. */
#define STUDY_REFINE_DEPTH 48

#endif
