/* plane_rows.h -- the curves of a plane study as points, by states. */
#pragma once

#include "plane_study.h"
#include "rows.h"

/* A point of a manifold. */
struct plane_point {
    double arc; /* arc length in the chart, from the saddle */
    double at[2];
    double slope; /* dy/dx in the chart */
    double error; /* bound on the distance to the exact curve, in the chart */
};

/* A point of a nullcline; of a trajectory. */
struct plane_place {
    double arc, at[2];
};
struct plane_moment {
    double time, at[2], value[PLANAR_OBSERVABLES_MAX];
};

/* An arrow of the direction field. */
struct plane_arrow {
    double at[2], direction[2], log10_speed;
};

/* What is shown of a branch, so dense that straight lines between the points
 * are within TOL_DRAWN of it.  Errors as curve_rows_branch. */
MUST_CHECK enum status plane_rows_branch(const struct plane_study *s,
                                         const struct plane_branch *b,
                                         struct rows *r);
MUST_CHECK enum status plane_rows_nullcline(const struct plane_study *s,
                                            const struct polyline *line,
                                            struct rows *r);
/* Both ways, from the earliest time on. */
MUST_CHECK enum status plane_rows_trajectory(const struct plane_study *s,
                                             size_t k, struct rows *r);
MUST_CHECK enum status plane_rows_arrows(const struct plane_study *s,
                                         struct rows *r);
