/*
 * interval_tape.h -- a tape (tape.h) over intervals: Taylor series of its rates
 * along two curves whose coefficients are intervals.  Where the coefficient of
 * order k holds the k-th derivative over k! at every point of a piece of a
 * curve, those of the rates do so, too: what Lagrange's remainder needs (Moore
 * 1966, ch. 11).  A series of order 1 that moves one coordinate only has the
 * partial derivative by it.
 *
 * Only quotients of rates of one call mean anything: all have the same factor
 * e^-log_scale, which the call chooses.
 */
#pragma once

#include "interval_graph.h"
#include "jet.h"
#include "tape.h"

struct interval_series {
    struct interval c[JET_SIZE];
};

/* Large. */
struct interval_tape {
    const struct tape *t; /* borrowed */
    struct interval constant[FORMULA_NODES];
    bool used[TAPE_STEPS];
    int rate[TAPE_RATES], rates; /* the chart's, and what else is asked for */
    /* e^c of the constant c of a rate's exponents is part e^whole: whole ones
     * are added without rounding, and only the rest is exponentiated */
    double whole[TAPE_RATES][TAPE_EXPONENTS];
    struct interval part[TAPE_RATES][TAPE_EXPONENTS];
    struct interval_series *series; /* owned: registers, and what they keep */
};

/* Constants of a graph that has been run, of which what t needs is known.
 * rate[]: of observables beyond those of the chart.  STATUS_NO_MEMORY. */
MUST_CHECK enum status interval_tape_init(struct interval_tape *out,
                                          const struct tape *t,
                                          const struct interval_graph *g,
                                          const int rate[], int rates);
void interval_tape_free(struct interval_tape *t);

/* Series to order n of the rates times e^-log_scale: out[0 .. rates - 1], the
 * chart's first. */
void interval_tape_jet(struct interval_tape *t, size_t n,
                       const struct interval x[], const struct interval y[],
                       struct interval_series out[], double *log_scale);

/* How much value 0 of the tape is at a box above what it is at the anchor. */
struct interval interval_tape_change(struct interval_tape *t, struct interval x,
                                     struct interval y);
