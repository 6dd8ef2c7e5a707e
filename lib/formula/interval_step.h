/*
 * interval_step.h -- for interval_tape.c only: the steps of a tape, as series
 * over intervals.
 */
#pragma once

#include "interval_tape.h"

enum { INTERVAL_REGISTERS = TAPE_STEPS + 2, INTERVAL_KEPT = 2 };

/* Series to order n, as far as they are made. */
struct interval_run {
    const struct interval_tape *t;
    size_t n;
    struct interval_series *reg, *keep;
    double sign[INTERVAL_REGISTERS];  /* of a sinh's argument, as it is taken */
    double scale[INTERVAL_REGISTERS]; /* of a scaled one */
};

/* Makes register i + 2. */
void interval_step(struct interval_run *r, int i);

/* A linear form, and its terms alone. */
void interval_linear(const struct interval_run *r, const struct linear *u,
                     struct interval out[]);
void interval_terms(const struct interval_run *r, const struct linear *u,
                    struct interval out[]);
