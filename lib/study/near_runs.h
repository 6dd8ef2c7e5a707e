/*
 * near_runs.h -- the runs that are too near the separatrix to be followed
 * (TRANSIENT_NEAR): how long they take and how far they slip, by the slow curve
 * (push.h), on which they are from the start.
 */
#pragma once

#include "push.h"
#include "transient.h"

/* Fills time, slip and mean friction of those among run[count] whose side of
 * the separatrix is certain; the runs' reasons stay, and so does that of a
 * number that is not known.  `scene` is theirs.  STATUS_NO_MEMORY,
 * STATUS_STOPPED. */
MUST_CHECK enum status near_runs_tell(const struct scene *scene, size_t count,
                                      const struct monitor *monitor,
                                      struct transient run[]);
