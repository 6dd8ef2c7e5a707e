/*
 * tally.h -- what draws say together: means with their errors, which hold in 95
 * of 100 ensembles of other seeds.
 *
 * Of independent draws (random, and samples taken as such) the error of a mean
 * is 1.96 s/sqrt(n).  Of scramblings it is that of their means
 * (ENSEMBLE_STUDENT).  A share of the draws has no error below
 * ENSEMBLE_NEVER/n.  A grid has none that could be told.
 */
#pragma once

#include <stddef.h>

#include "draws.h"
#include "ensemble_tolerance.h"

/* A mean or a share; NaN: not there; error NaN: not known. */
struct estimate {
    double value, error;
};

/* Of the draws of one repeat: Welford's running mean and sum of squares. */
struct tally {
    struct tally_part {
        double count, mean, squares;
    } part[ENSEMBLE_REPEATS];
};

void tally_add(struct tally *t, size_t repeat, double x);

/* The mean of all, with the mean's error. */
struct estimate tally_mean(const struct tally *t, const struct draws *d);

/* The same of x that are 0 or 1. */
struct estimate tally_share(const struct tally *t, const struct draws *d);

/* The variance of all. */
double tally_variance(const struct tally *t);

/* The mean of so many values of the repeats, each of an equal weight, with its
 * error over them; no error where one of them is NaN. */
struct estimate tally_repeats(const double value[ENSEMBLE_REPEATS]);
