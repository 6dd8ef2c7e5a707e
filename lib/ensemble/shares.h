/*
 * shares.h -- which part of a number's variance each parameter makes by itself:
 * first-order indices of Sobol',
 *
 *     S_k = Var(E[Y | X_k])/Var(Y),
 *
 * from the draws that there are, however they were drawn and whether parameters
 * depend on one another or not: X_k is cut into bins of equal probability at
 * its quantiles, and the variance between them, freed from what the scatter
 * within them adds (the estimator omega^2 of the analysis of variance), is
 * taken (Plischke, Borgonovo & Smith, Eur. J. Oper. Res. 226 (2013) 536-550).
 * Pick-and-freeze (Saltelli 2002) would need as many draws again for each
 * parameter, and cannot be had of samples.
 *
 * The error is that of the repeats' own indices, and what the number of bins
 * makes: what varies within a bin falls as its width squared, so that with half
 * as many it is four times as much, and the difference is above it.  Scrambled
 * points scatter less between bins than independent ones do, between not at all
 * and as much: half of that is taken, and the other half is in the error.
 */
#pragma once

#include "spool.h"
#include "tally.h"

/* S of number `number` by each key, into share[keys]; NaN where it has no
 * variance, or there are too few draws; center: about its mean.  STATUS_IO,
 * STATUS_NO_MEMORY. */
MUST_CHECK enum status shares_find(const struct spool *s, const struct draws *d,
                                   size_t number, double center,
                                   struct estimate share[], struct fault *why);
