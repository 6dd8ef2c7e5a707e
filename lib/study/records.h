/* records.h -- the tables by which a study's results describe themselves:
 * they drive the HDF5 file, the JSON and the documentation. */
#pragma once

#include "estimate_numbers.h"
#include "numbers.h"
#include "sensitivity.h"

/* A stored point of a branch.  Integrals run from the saddle where they
 * converge there (excess), else from the first point after it. */
struct branch_row {
    double arc; /* arc length in the chart (ln v, ln psi), from the saddle */
    double v, psi;
    double slope; /* d ln psi/d ln v (d psi/d ln v where psi is a logarithm) */
    double slip, time, work, excess;
    double error; /* bound on the distance to the exact curve, in the chart */
};

/* A point of a nullcline. */
struct nullcline_row {
    double arc, v, psi;
};

/* A point of a trajectory. */
struct trajectory_row {
    double time, v, psi, slip, mu, work;
};

/* An arrow of the direction field. */
struct arrow_row {
    double v, psi;
    double direction_v, direction_psi; /* unit vector as drawn */
    double log10_speed;                /* of (ln v, ln psi) per t* */
};

/* Of the structs here and in the headers above. */
extern const struct record_type record_arrow, record_estimates, record_xi,
    record_sensitivity;
extern const struct record_type record_steady, record_folds, record_saddle,
    record_critical, record_knee, record_branch, record_nullcline,
    record_trajectory;

/* "psi_inf", "open", "psi_0", "v_0", "truncated": by enum end_code. */
extern const char *const end_names[];
