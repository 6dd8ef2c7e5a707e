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
#include "output.h"
#include "sweep_options.h"

/* A sweep or an ensemble in the making. */
struct shared_work {
    const char *name;         /* "sweep" */
    const char *tasks;        /* "points" */
    const char *const *panel; /* of its figure, as of panel_path */
    void *work;
    enum status (*run)(void *work, const struct scene *scene,
                       const struct sweep_options *how,
                       const struct monitor *monitor, struct fault *why);
    void (*free)(void *work);
    enum status (*write)(const void *work, const char *path, struct fault *why);
    enum status (*draw)(const void *work, struct panels *p, struct fault *why);
    /* Text or JSON; then what is to be noted of the run, or NULL. */
    enum exit_code (*print)(const void *work, const struct options *o);
    void (*note)(const void *work);

    /* Members of *work after run: tasks in all, those of others, those that
     * were there already, and whether a side file was left and replaced. */
    const size_t *count, *missing;
    size_t *taken;
    const bool *replaced;
};

/* Runs it, writes its file and figure, prints it and frees it; of a share what
 * there is of it.  Nothing is left beside a file that was written. */
enum exit_code shared_command(const struct shared_work *w,
                              const struct options *o,
                              const struct scene *scene);
