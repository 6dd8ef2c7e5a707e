/*
 * threshold.h -- where a margin that is known at samples is zero, as a graph:
 * with z_j the score that m hangs on most, z_j is fitted, by weighted least
 * squares, by a polynomial of m and the other scores,
 *
 *     sum over samples of (z_j - p(m/s, others))^2/(1 + (m/s)^2)^2 -> min,
 *
 * s the root mean square of m, and g(others) = p(0, others).  Where m is
 * monotone in z_j that is a function, and smooth where m is.
 */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "ensemble_tolerance.h"
#include "status.h"

/* Term i is term of[i] times variable by[i]; term 0 is one.  All of a degree
 * come before those of the next. */
struct threshold {
    bool there; /* else there are too few samples, or they tell nothing */
    size_t scores, pivot; /* of z; j */
    size_t terms;
    uint16_t of[THRESHOLD_TERMS], by[THRESHOLD_TERMS];
    double coefficient[THRESHOLD_TERMS];
};

/* By rows m, z[scores] of `count` samples.  STATUS_NO_MEMORY. */
MUST_CHECK enum status threshold_fit(struct threshold *t, const double row[],
                                     size_t count, size_t scores);

/* g at z, whose z_j does not matter. */
double threshold_at(const struct threshold *t, const double z[]);
