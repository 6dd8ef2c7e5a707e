/*
 * neighbours.h -- how all numbers of a study answer to an input, by central
 * differences of studies in which it is moved: good to about two digits.
 *
 *     struct neighbours f;
 *     neighbours_init(&f, &study, STUDY_NUMBERS);
 *     neighbours_rates(&f, move, ctx, rate);
 *     neighbours_free(&f);
 *
 * Numbers are those that exist in the study and come from some of its stages:
 * STUDY_NUMBERS, read off the equilibria, folds, branches, knees and estimates,
 * and perhaps the shares of its basins, for which no cell is followed.
 */
#pragma once

#include "status.h"
#include "unit.h"

struct scene;
struct study;
struct neighbour;

enum { NEIGHBOUR_NUMBERS = 512 };

/* The numbers of a study, in a fixed order. */
struct numbers {
    struct quantity *at[NEIGHBOUR_NUMBERS]; /* borrowed */
    const struct unit *unit[NEIGHBOUR_NUMBERS];
    size_t count;
};

struct neighbours {
    struct study *s;          /* borrowed */
    uint64_t stages;          /* that numbers come from */
    struct numbers numbers;   /* of s */
    struct neighbour *around; /* owned */
    bool same;                /* at an accuracy fit for differences, too */
    size_t evaluations;       /* of the field, so far */
};

/* d q/d nudge, infinite where no neighbour has the number; of the number as it
 * is and as the SI has it (the same of an angle). */
struct neighbour_rate {
    double own, si;
    bool settled; /* both neighbours have it, and tell alike */
};

/* Moves an input; false: that is out of its range. */
typedef bool neighbour_move(const void *ctx, double nudge, struct scene *c);

/* stages: STUDY_NUMBERS, or STUDY_NUMBERS | ASKED_BY(BASINS).  STATUS_NO_MEMORY
 * leaves *f empty. */
MUST_CHECK enum status neighbours_init(struct neighbours *f, struct study *s,
                                       uint64_t stages);

/* Into rate[f->numbers.count].  STATUS_NO_MEMORY. */
MUST_CHECK enum status neighbours_rates(struct neighbours *f,
                                        neighbour_move *move, const void *ctx,
                                        struct neighbour_rate rate[]);

/* A second call is harmless. */
void neighbours_free(struct neighbours *f);
