/*
 * sample.h -- points of a run (transient.h) at given times or slips, from the
 * dense output of its orbit, which is as good as its steps.
 */
#pragma once

#include "records.h"
#include "transient.h"

/* Of the components of an orbit with all observables (orbit.h). */
struct trajectory_row sample_row(const struct slider *s, const double u[]);

/* Where time (slip) has the value, or the end of the run before that.  The run
 * must have a length. */
struct trajectory_row sample_at_time(const struct slider *s,
                                     const struct transient *t, double time);
struct trajectory_row sample_at_slip(const struct slider *s,
                                     const struct transient *t, double slip);

/* n >= 2 points equally far apart in slip, from the start to the end; and in
 * ln(time), from the end of the first step, which is as short as the fastest
 * change at the start, or of the first with a time of doubles' full precision.
 * row[n]. */
void sample_linear_slip(const struct slider *s, const struct transient *t,
                        size_t n, struct trajectory_row row[]);
void sample_log_time(const struct slider *s, const struct transient *t,
                     size_t n, struct trajectory_row row[]);
