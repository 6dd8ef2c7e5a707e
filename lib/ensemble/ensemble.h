/*
 * ensemble.h -- the numbers of many materials, and the fates of states under
 * them: what is known where parameters are not.
 *
 *     struct ensemble e;
 *     ensemble_run(&e, &scene, &(struct sweep_options){ 0 }, NULL, &fault);
 *     ... e.number[k].quantile, e.push[k].fate ...
 *     ensemble_free(&e);
 *
 * What flows where:
 *
 *     draws -> batch -> spool -+-> tally             (means, probabilities)
 *                              +-> quantile, shares  (more passes)
 *                              +-> whoever writes files
 *
 * Memory holds a block of draws, however many there are.  All of it is the same
 * at any number of threads.
 */
#pragma once

#include "batch.h"
#include "fate.h"
#include "spool.h"
#include "tally.h"
#include "variate.h"

/* 0.025, 0.16, 0.5, 0.84, 0.975. */
enum { ENSEMBLE_QUANTILES = 5 };
extern const double ensemble_quantile[ENSEMBLE_QUANTILES];

struct ensemble_number {
    const char *name, *unit;             /* borrowed from the batch */
    double quantile[ENSEMBLE_QUANTILES]; /* of those that exist; NaN: none */
    struct estimate mean;                /* likewise; with their mean bar */
    struct estimate exists;              /* share of all draws */
    size_t reason[REASONS_MAX];          /* how many lack it, by code */
    struct estimate *share;              /* owned; by key: shares.h */
};

struct ensemble_push {
    const char *from, *unit, *state; /* as files have them */
    struct scene_push at;            /* psi NaN: from creep */
    char said[128];                  /* as people read it */
    const char *word[GOALS]; /* borrowed: of fates, by code; of attractors,
                                those most come to first; NULL: no goal */
    struct estimate fate[GOALS + 1]; /* of all draws; the last: none */
    struct estimate arrest;          /* creep or either rest; of a law */
    size_t count[GOALS + 1];
    size_t reason[REASONS_MAX]; /* why it is none, or undecided */
};

struct ensemble {
    const struct scene *scene;      /* borrowed */
    struct draws draws;             /* owned */
    struct batch batch;             /* owned */
    struct sweep_reasons reasons;   /* owned */
    struct spool spool;             /* owned */
    struct ensemble_number *number; /* owned; batch.numbers of them */
    struct ensemble_push *push;     /* owned; batch.pushes */
    size_t taken;                   /* draws that an interrupted run had left */
    size_t missing; /* draws that are of other shares: then there is no summary,
                       and those that are ours are in the side file */
    bool replaced;  /* a side file was left, not asked for, and replaced */
};

/* Harmless to free. */
#define ENSEMBLE_EMPTY                                                         \
    ((struct ensemble){ .draws = { .id = -1 },                                 \
                        .spool = { .journal = { .file = -1 } } })

/* Runs scene->ensemble.  STATUS_BAD_SCENE: with the place of what is wrong, in
 * the scene or in a file that it names; the side file to resume is another's.
 * STATUS_STOPPED by the monitor: the side file stays.  STATUS_IO,
 * STATUS_NO_MEMORY.  On error *e is empty and *why is one line. */
MUST_CHECK enum status ensemble_run(struct ensemble *e,
                                    const struct scene *scene,
                                    const struct sweep_options *options,
                                    const struct monitor *monitor,
                                    struct fault *why);

/* Whether the scene has one. */
bool ensemble_is_asked(const struct scene *scene);

/* A second call is harmless. */
void ensemble_free(struct ensemble *e);
