/* chi_curve.h -- chi(v), (34): the slope d ln psi/d ln v of the direction field
 * on the line psi = psi_sp0, for several slope angles (Fig 10).  Where chi = 1,
 * the paper looks for the knees of the saddle's stable manifold. */
#pragma once

#include "law.h"
#include "record.h"
#include "status.h"

/* One slope angle, which is exact, and its row of ln chi. */
struct chi_slope {
    double alpha;                  /* rad */
    struct quantity v_sp0;         /* (29) */
    struct quantity v_low, v_high; /* both roots of chi(v) = 1 */
};

extern const struct record_type record_chi_slope;

/* Slopes as given, points ascending in v; ln chi and its absolute error at
 * [slope * points + point], NaN where the slope has no v_sp0. */
struct chi_curves {
    struct chi_slope *slope; /* owned */
    double *v;               /* owned; dimensionless, exact */
    double *ln_chi, *error;  /* owned */
    size_t slopes, points;
    const char *reason; /* static: why there is no curve; NULL if there is */
};

/* The points v[STUDY_CURVE_POINTS] of the curves, evenly in ln v from range[0]
 * to range[1]. */
void chi_curves_points(const double range[2], double v[]);

/*
 * With x = ln(v/v_sp0) and the approximations of (34) - log form, c = 0 -
 *
 *     chi = eps^2 v^2 sinh(psi_sp0 - 1/v)/(eta psi_sp0 a cos(alpha) x),
 *
 * positive for every v and finite at v_sp0; from v[0] to v[1].
 * STATUS_NO_MEMORY leaves *c empty.
 */
MUST_CHECK enum status chi_curves_find(const struct law *law,
                                       const struct material *m,
                                       const double alpha[], size_t slopes,
                                       const double v[2], struct chi_curves *c);

/* A second call is harmless. */
void chi_curves_free(struct chi_curves *c);
