/* plane_sensitivity.h -- how the equilibria of a plane and their eigenvalues
 * answer to the parameters, and what rounding of the parameters costs them. */
#pragma once

#include "plane_study.h"

/* Fills s->slope, and the conditioning of the equilibria's numbers:
 *
 *     sum over parameters p of |dq/dp| |p| 2^-53/|q|, none where q is 0.
 *
 * A derivative is the central difference D(h) = (q(p + h) - q(p - h))/2h of
 * numbers known to 113 bits.  D(h) - dq/dp = h^2 q'''/6 with q''' from between,
 * so that D(h/2) is off by a third of |D(h) - D(h/2)| where q''' is constant;
 * the bar is all of it, and the bars of the four q over their steps: it holds
 * unless q''' changes by a factor of 3 within h = 2^-30 |p|.
 *
 * Conditioning where the scene's products have sensitivities; where parameters
 * scatter, "a: X +- S", the spread of the same numbers: spread^2 is the sum of
 * (dq/da)^2 S^2.
 *
 * STATUS_NO_MEMORY, STATUS_STOPPED. */
MUST_CHECK enum status plane_sensitivity_find(struct plane_study *s,
                                              const struct monitor *monitor);
