/* study_manifold.h -- the stages of a study that grow the saddle's manifolds.
 * Where there is no saddle they do nothing. */
#pragma once

#include "study.h"

/* The stable branches of n <= STUDY_JOBS studies without a failure, side by
 * side; a failure is told in its job. */
void study_stable(struct study_job job[], size_t n,
                  const struct monitor *monitor);

/* The unstable ones of one, as far as orbits get.  Errors as orbit_run, with
 * *why. */
MUST_CHECK enum status study_unstable(struct study *s,
                                      const struct monitor *monitor,
                                      struct fault *why);
