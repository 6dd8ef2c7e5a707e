/* start_numbers.h -- a run (transient.h) in numbers of one shape: those of the
 * whole, its phases, and of each kind of event the first. */
#pragma once

#include "study.h"
#include "transient.h"

struct start_numbers {
    struct transient_summary sum;
    struct phase phase[PHASES];
    struct transient_event first[MOMENTS]; /* by enum moment */
    /* |mu - tan(alpha)| falls below, rises above a level, by level */
    struct transient_event nears[MOMENT_LEVELS_MAX];
    struct transient_event leaves[MOMENT_LEVELS_MAX];
};

/* Of the run from `start`, with the options of the scene.  What does not happen
 * has that as its reason.  Errors as transient_find; *out is then
 * undefined. */
MUST_CHECK enum status start_numbers_find(const struct study *s,
                                          struct scene_start start,
                                          const struct monitor *monitor,
                                          struct start_numbers *out);
