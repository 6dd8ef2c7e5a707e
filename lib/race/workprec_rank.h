/* workprec_rank.h -- the runs of a race, and who was fastest at an accuracy. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "record.h"
#include "status.h"

enum workprec_status {
    WORKPREC_DONE,
    WORKPREC_FAILED, /* says the method, or it took too many evaluations */
    WORKPREC_SILENT_FAILURE /* says success, but is off by far more than its
                               tolerance (WORKPREC_SILENT), or its own bar */
};
extern const char *const workprec_status_names[];

/* One method on one quantity at one tolerance. */
struct workprec_run {
    int8_t quantity;    /* enum workprec_quantity */
    const char *method; /* borrowed, static; equal ones are the same pointer */
    int8_t foreign;     /* 0, 1 */
    double rtol;
    double true_error, reported_error; /* reported: NaN where it has none */
    double seconds;
    int64_t field_evaluations, steps;
    int8_t status; /* enum workprec_status */
};
extern const struct record_type record_workprec_run;

/* Of one quantity at one true error; times between runs are interpolated, their
 * logarithms linearly over those of the errors.  NULL and NaN where nobody gets
 * there. */
struct workprec_fastest {
    int8_t quantity;
    double accuracy;
    const char *method; /* of all */
    double seconds;
    const char *own, *foreign; /* the fastest of ours, and of others */
    double own_seconds, foreign_seconds;
    double ratio_to_best_foreign; /* foreign_seconds over own_seconds */
};
extern const struct record_type record_workprec_fastest;

/* Seconds to a true error for the `count` runs of one method on one quantity,
 * tolerances falling; infinite where it does not get there. */
double workprec_time_at(const struct workprec_run run[], size_t count,
                        double accuracy);

/* Ranks of all quantities among the runs, which are ordered by quantity and
 * method: *ranks of them, owned by the caller.  STATUS_NO_MEMORY. */
MUST_CHECK enum status workprec_rank(const struct workprec_run run[],
                                     size_t runs, struct workprec_fastest **out,
                                     size_t *ranks);
