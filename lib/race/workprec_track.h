/*
 * workprec_track.h -- the quantities of a task by an integrator (method.h),
 * set up as well as a careful user would.
 *
 * Branches: backward in arc length, from a point of the saddle's series, which
 * every run finds for itself, as ours do; limits are reached where the slope,
 * all that is still to come, is a tenth of the tolerance.  Rows, and arrest,
 * are found on the last step by the method's own interpolation.
 */
#pragma once

#include "method.h"
#include "workprec_answer.h"

/* *out says whether the method thinks it succeeded; it gives up after
 * calls_most evaluations. */
void workprec_track(const struct workprec_task *c, enum workprec_quantity q,
                    const struct method *m, double tol, size_t calls_most,
                    struct workprec_answer *out);
