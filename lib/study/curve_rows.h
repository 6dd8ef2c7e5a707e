/* curve_rows.h -- a study's curves as tables of points, for files and
 * figures. */
#pragma once

#include "rows.h"
#include "study.h"

/* Points of a stable branch (struct branch_row), so dense that cubic Hermite
 * interpolation with the stored slopes (of ln psi over ln v where |slope| < 1,
 * of ln v over ln psi elsewhere) is within TOL_SAME of the curve.  Rows are
 * added to *r; on error *r holds what fitted. */
MUST_CHECK enum status curve_rows_branch(const struct study *s,
                                         const struct branch *b,
                                         struct rows *r);

/* The same of an unstable branch. */
MUST_CHECK enum status curve_rows_unstable(const struct study *s,
                                           const struct orbit *o,
                                           struct rows *r);

/* A trajectory (struct trajectory_row), a few points a step, of those with one
 * time only one: times grow from row to row. */
MUST_CHECK enum status curve_rows_trajectory(const struct study *s,
                                             const struct curve *c,
                                             struct rows *r);

/* How an orbit ended; what is not known of it is NULL. */
struct run_end {
    const char *end, *fate, *comment;
    double energy_defect;
};
extern const struct record_type record_run_end;

MUST_CHECK enum status curve_rows_lend_end(struct result_view *out,
                                           struct run_end end);
