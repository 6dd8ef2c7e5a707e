/*
 * parabola.h -- Rabinowicz's experiment read backwards: from critical release
 * distances l_k at several slopes the two roots and the factor of (33),
 *
 *     l_k tan(alpha) = factor (mu_s - tan alpha)(mu_half - tan alpha),
 *
 * mu_half = mu_ss(V_star/2) the smaller root, factor = eta L/(K (b - a)).
 *
 * The 95 % interval of a root is where the curve's own 95 % band holds zero
 * (Fieller, J. R. Stat. Soc. B 16, 1954, 175-185): exact however wide it is,
 * lopsided, without an end where the data set none, and common to both roots
 * where they cannot be told apart.
 */
#pragma once

#include <stdint.h>

#include "least.h"
#include "record.h"

/* The error of a quantity is how far its 95 % interval reaches. */
struct parabola {
    struct quantity mu_s, mu_half; /* the roots, mu_s the larger */
    struct quantity factor;        /* in the unit of l_k */
    struct quantity mu_middle;     /* half the sum of the roots */
    /* 95 % intervals; infinite where the data set no end, NaN without value */
    double mu_s_low, mu_s_high, mu_half_low, mu_half_high;
    double factor_low, factor_high;
    /* Standard deviations and covariances; NaN where there is no value. */
    double mu_s_deviation, mu_half_deviation, factor_deviation;
    double mu_s_mu_half, mu_s_factor, mu_half_factor;
    int64_t points, freedom;
    double chi2;         /* in units of the errors; without them relative */
    double scatter;      /* relative, of one l_k; NaN where errors were given */
    double chance;       /* of a chi2 as large or larger; NaN without errors */
    const char *warning; /* one plain sentence, static; NULL: none */
};
extern const struct record_type record_parabola;

/* l_k over tan alpha.  Data that have no such parabola (too few, or bent the
 * other way) are a reason in every quantity, not an error.
 * STATUS_NO_CONVERGENCE, STATUS_NO_MEMORY: *out is untouched. */
MUST_CHECK enum status parabola_fit(const struct measured *m,
                                    struct parabola *out);
