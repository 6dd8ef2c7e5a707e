/*
 * shared.h -- a sweep or an ensemble run by this process alone, as one share of
 * it (--shard), from shares that are there (merge), or by the ranks of
 * slipway-mpi.
 *
 * Ranks take turns: the first joins what all have left in side files, says how
 * much is missing, and all compute some of it, each into a side file of its
 * own; once more for each refinement.  So a run that was killed is there to be
 * resumed, by any number of ranks, and the result is that of one process.
 */
#pragma once

#include "monitor.h"
#include "options.h"
#include "status.h"
#include "sweep_options.h"

/* What is run, of functions as sweep_run's. */
struct shared_work {
    enum status (*run)(void *work, const struct sweep_options *how,
                       const struct monitor *monitor, struct fault *why);
    void (*free)(void *work);
    void *work;
    const size_t *missing; /* members of *work after run: tasks of others, */
    size_t *taken;         /* and those that were there already */
};

/* journal: the side file of a run alone (parts.h), whose folder is made; NULL:
 * none.  *whole: all is there, and it is for this process to write it; else the
 * work has its share (missing) or, on another rank, nothing; it is to be freed
 * in any case.  Errors as those of run; STATUS_BAD_ARGUMENT, BAD_SCENE: shares
 * that are wrong or not there. */
MUST_CHECK enum status shared_run(const struct shared_work *w,
                                  const struct options *o, const char *journal,
                                  bool *whole, struct fault *why);
