/*
 * sweep_shared.h -- a sweep run by this process alone, as one share of it
 * (--shard), from shares that are there (merge), or by the ranks of
 * slipway-mpi.
 *
 * Ranks take turns: the first joins what all have left in side files, says how
 * many points are missing, and all compute some of them, each into a side file
 * of its own; once more for each refinement.  So a run that was killed is there
 * to be resumed, by any number of ranks, and the result is that of one process.
 */
#ifndef APPS_SWEEP_SHARED_H
#define APPS_SWEEP_SHARED_H

#include "options.h"
#include "sweep.h"

/* journal: the side file of a run alone (parts.h); NULL: none.  *whole: all
 * points are there, and it is for this process to write them; else *s has those
 * of the share (sweep.h: missing) or, on another rank, none.  Errors as
 * sweep_run; STATUS_BAD_ARGUMENT, BAD_SCENE: shares that are wrong or not
 * there. */
MUST_CHECK enum status sweep_shared(struct sweep *s, const struct scene *scene,
                                    const struct options *o,
                                    const char *journal, bool *whole,
                                    struct fault *why);

#endif
