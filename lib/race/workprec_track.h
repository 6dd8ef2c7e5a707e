/*
 * workprec_track.h -- the quantities of a course by an integrator (method.h),
 * set up as well as a careful user would.
 *
 * Branches: backward in arc length, from a point of the saddle's series, which
 * is given; limits are reached where the slope, all that is still to come,
 * is a tenth of the tolerance.  Rows, and arrest, are found on the last step by
 * the method's own interpolation.
 */
#ifndef RACE_WORKPREC_TRACK_H
#define RACE_WORKPREC_TRACK_H

#include "method.h"
#include "workprec_answer.h"

/* Given to every integrator: points of both branches on the saddle's series
 * where that is good to a hundredth of the tolerance, with the excess slip from
 * the saddle to there. */
struct workprec_start {
    struct vec2 z[WORKPREC_SIDES];
    struct vec2 near[WORKPREC_SIDES]; /* before the first row */
    double excess;
};

/* For a tolerance; errors as local_at. */
MUST_CHECK enum status workprec_start_find(const struct workprec_course *c,
                                           double tol,
                                           struct workprec_start *out);

/* *out says whether the method thinks it succeeded; it gives up after
 * calls_most evaluations. */
void workprec_track(const struct workprec_course *c, enum workprec_quantity q,
                    const struct method *m, double tol,
                    const struct workprec_start *start, size_t calls_most,
                    struct workprec_answer *out);

#endif
