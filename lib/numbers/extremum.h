/* extremum.h -- the extrema of steady-state friction: where steady states
 * appear and vanish in pairs as the slope changes, (15), (16). */
#pragma once

#include "law.h"
#include "record.h"

enum extremum_kind { EXTREMUM_MAXIMUM, EXTREMUM_MINIMUM };
extern const char *const extremum_names[]; /* NULL-ended */

struct extremum {
    int8_t kind;       /* enum extremum_kind */
    struct quantity v; /* dimensionless, as psi */
    struct quantity psi;
    struct quantity mu;    /* mu_ss(v) */
    struct quantity alpha; /* rad: atan mu; none where mu < 0 */
    long double x;         /* ln v */
};

extern const struct record_type record_extremum;

enum { EXTREMA_MAX = 4 };

/* All of them with v in [1e-300, 1e300], ascending; their number. */
size_t extremum_find(const struct law *law, const struct material *m,
                     struct extremum out[EXTREMA_MAX]);

/* atan mu, the slope on which mu balances; none where mu <= 0. */
struct quantity extremum_angle(const struct quantity *mu);
