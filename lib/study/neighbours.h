/*
 * neighbours.h -- how all numbers of a study answer to an input, by central
 * differences of studies in which it is moved: good to about two digits.
 *
 *     struct neighbours f;
 *     neighbours_init(&f, &study);
 *     neighbours_rates(&f, move, ctx, rate);
 *     neighbours_free(&f);
 *
 * Numbers are those that exist in the study and are read off the equilibria,
 * folds, branches, knees and estimates (STUDY_NUMBERS).
 */
#pragma once

#include "record.h"
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

/* d q/d nudge from a number, q[0], and from those of its two neighbours; false
 * where they do not tell it: one is missing, or the two differences are
 * unlike. */
bool neighbours_rate(const struct quantity q[3], double nudge, double *rate);

/* Moves an input; false: that is out of its range. */
typedef bool neighbour_move(const void *ctx, double nudge, struct scene *c);

/* STATUS_NO_MEMORY leaves *f empty. */
MUST_CHECK enum status neighbours_init(struct neighbours *f, struct study *s);

/* Into rate[f->numbers.count].  STATUS_NO_MEMORY. */
MUST_CHECK enum status neighbours_rates(struct neighbours *f,
                                        neighbour_move *move, const void *ctx,
                                        struct neighbour_rate rate[]);

/* A second call is harmless. */
void neighbours_free(struct neighbours *f);
