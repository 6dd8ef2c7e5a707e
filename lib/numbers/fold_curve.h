/* fold_curve.h -- both folds of the steady states in the plane of slope angle
 * and c, to the cusp where they meet (Fig 4).  Between them, three steady
 * states: the block may creep or slide. */
#pragma once

#include "extremum.h"
#include "status.h"

/* The folds at one c, which is exact. */
struct fold_point {
    double c;
    struct quantity alpha_cm, alpha_cM; /* rad, (16) */
    struct quantity v_m, v_M;
    struct quantity mu_m, mu_M;
};

struct cusp_numbers {
    struct quantity c;
    struct quantity v, psi, mu;
    struct quantity alpha; /* rad */
};

extern const struct record_type record_fold_curve, record_cusp;

struct fold_curve {
    struct fold_point *at; /* owned; ascending in c */
    size_t count;
    struct cusp_numbers cusp;
    const char *reason; /* static: why there is no curve; NULL if there is */
};

/* From c[0] to c[1] or close to the cusp, whichever comes first; denser towards
 * the cusp, where slip rates go like the square root of the distance; m->c
 * plays no part.  STATUS_NO_MEMORY leaves *f empty. */
MUST_CHECK enum status fold_curve_find(const struct law *law,
                                       const struct material *m,
                                       const double c[2], struct fold_curve *f);

/* A second call is harmless. */
void fold_curve_free(struct fold_curve *f);
