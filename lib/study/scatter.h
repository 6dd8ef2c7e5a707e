/*
 * scatter.h -- what the scatter of the inputs, "a: X +- S", makes of the
 * numbers of a study: to first order, inputs being independent, the standard
 * deviation
 *
 *     spread^2 = sum over these inputs p of (dq/dp)^2 S_p^2,
 *
 * the derivatives being central differences (neighbours.h).  In the SI a number
 * scatters with V_star, L and phi_1, too, and has a spread of its own.  It says
 * nothing of how q bends, and of folds that are near: an ensemble does.
 */
#pragma once

#include <stddef.h>

#include "monitor.h"
#include "status.h"

struct study;

/* Fills `spread` of every number that exists in s: infinite where no neighbour
 * in an input has the number.  *evaluations grows by the field evaluations.
 * STATUS_NO_MEMORY, STATUS_STOPPED: some are filled. */
MUST_CHECK enum status scatter_find(struct study *s,
                                    const struct monitor *monitor,
                                    size_t *evaluations);
