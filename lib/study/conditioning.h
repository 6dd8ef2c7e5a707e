/*
 * conditioning.h -- what the rounding of the inputs costs every number of a
 * study: the relative change
 *
 *     sum over inputs p of |d ln q/d p| |p| 2^-53,
 *
 * by central differences of recomputed studies, good to about two digits.
 * Inputs: alpha (or tan_alpha), mu_star, a, b, c, R, V_c, L, V_star, g as far
 * as the law uses them.
 */
#pragma once

#include "monitor.h"
#include "sensitivity.h"

struct study;

/* Fills `conditioning` of every number that exists in s and is read off the
 * equilibria, folds, branches, knees and estimates: infinite where no
 * neighbour of an input has the number, NaN where s differs too much from
 * itself at a finer rtol.  Where a sensitivity in *exact is further from the
 * differences than both allow, its error grows to that.  *evaluations grows by
 * the field evaluations.
 *
 * STATUS_NO_MEMORY, STATUS_STOPPED: some are filled. */
MUST_CHECK enum status conditioning_find(struct study *s,
                                         const struct monitor *monitor,
                                         struct sensitivities *exact,
                                         size_t *evaluations);
