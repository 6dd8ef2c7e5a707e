/*
 * quantile.h -- order statistics of a column of the spool, exactly, by passes
 * over the file: memory does not grow with the number of draws.
 *
 * Doubles in the order of their bits (the sign turned) are counted by their
 * first 8 bits, then within the class that holds the rank by the next 8, and
 * so on: eight passes, whatever the number of ranks (radix selection: Knuth,
 * TAOCP 3, sec. 5.2.5, used on a file).
 */
#pragma once

#include "spool.h"

enum { QUANTILES_MAX = 64 };

/* The quantiles p[0 .. n - 1], ascending, 0 < p < 1, of the values of a key, or
 * of a number where it exists: with m values x_(1) <= ... <= x_(m) the one with
 * rank ceil(p m), as type 1 of Hyndman & Fan (Am. Stat. 50 (1996) 361-365); NaN
 * where m = 0.  STATUS_IO, STATUS_NO_MEMORY. */
MUST_CHECK enum status quantile_find(const struct spool *s,
                                     enum spool_kind kind, size_t k,
                                     const double p[], size_t n, double out[],
                                     struct fault *why);
