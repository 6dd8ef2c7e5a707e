/*
 * verify.h -- the critical numbers of a slope once more, by the second route
 * (backward.h), beside those of the first (grow.h).
 *
 * Both routes share the field, the saddle, its eigenvalues and what rounding of
 * the field costs a number (numbers.h); everything else is done twice.
 */
#pragma once

#include "monitor.h"
#include "numbers.h"

/* Two values of a number.  They agree where |difference| <= the sum of their
 * errors, or where neither exists. */
struct verified_number {
    const char *name; /* as in record_critical; static */
    struct quantity first, second;
    double difference; /* first - second; NaN where either does not exist */
    bool agree;
};

/* How a branch ends, both ways: enum end_code. */
struct verified_end {
    const char *name; /* as in record_critical; static */
    int8_t first, second;
    bool agree;
};

enum { VERIFIED_ENDS = 2, VERIFIED_NUMBERS = 5 };

struct verification {
    struct verified_end end[VERIFIED_ENDS];          /* upper_end, lower_end */
    struct verified_number number[VERIFIED_NUMBERS]; /* v_plus, v_minus,
                                           psi_at_v0, x_excess, x_deficit */
    size_t disagreements;                            /* among all of these */
    size_t field_evaluations;
};

/* The saddle `e` at sys->origin, b's anchor; `first` are the numbers found for
 * it; `rtol` as asked of them.
 * STATUS_NO_CONVERGENCE, STATUS_TOO_MANY_STEPS: the second route failed, or the
 * first one's lower branch, whose end it does not know, has one by the second;
 * STATUS_STOPPED;
 * STATUS_NO_MEMORY; *out is then undefined. */
MUST_CHECK enum status verify_numbers(
    const struct block *b, const struct planar *sys,
    const struct equilibrium *e, const struct critical_numbers *first,
    double rtol, const struct monitor *monitor, struct verification *out);
