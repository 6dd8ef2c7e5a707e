/*
 * persistence.h -- memory length and friction from the persistence lengths x_k
 * at several slopes, by (30),
 *
 *     x_k = 2 eta L atanh(exp(-psi_sp)),
 *     psi_sp = exp(-(mu_star - tan alpha)/(b - a)),
 *
 * whose straight part (31) gives both: slope -eta L/(b - a), zero at mu_half.
 */
#pragma once

#include <stdint.h>

#include "least.h"
#include "record.h"

/* The error of a quantity is how far its 95 % interval reaches. */
struct persistence {
    struct quantity L;                               /* in the unit of x_k */
    struct quantity mu_star;                         /* friction at V_star */
    double L_low, L_high, mu_star_low, mu_star_high; /* 95 % intervals */
    double L_deviation, mu_star_deviation;           /* standard deviations */
    double L_mu_star;                                /* covariance */
    int64_t points, freedom;
    double chi2, scatter, chance; /* as of struct parabola */
    const char *warning;          /* one plain sentence, static; NULL: none */
};
extern const struct record_type record_persistence;

/* x_k over tan alpha.  What cannot be fitted (b <= a, too few data, or not
 * falling with the slope) is a reason in the quantities, not an error.
 * STATUS_NO_CONVERGENCE, STATUS_NO_MEMORY: *out is untouched. */
MUST_CHECK enum status persistence_fit(const struct measured *m, double eta,
                                       double b_minus_a,
                                       struct persistence *out);
