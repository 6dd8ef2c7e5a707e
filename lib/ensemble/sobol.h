/*
 * sobol.h -- scrambled Sobol points, each by its number: any block of them, by
 * any thread.
 *
 * The sequence is GSL's (Bratley & Fox, ACM TOMS 14 (1988) 88-100), with the
 * origin, which GSL leaves out, as point 0: only with it are the first 2^m
 * points a net.  Its digits are scrambled as by Owen (Monte Carlo and
 * Quasi-Monte Carlo Methods, 1995, 299-317): each binary digit is flipped by a
 * random bit that depends on all digits before it.  A digital shift, whose bits
 * do not, would be as unbiased; but under nested scrambling the variance of a
 * mean of n points is o(1/n) for every square-integrable function, and
 * O(log(n)^(d-1)/n^3) for smooth ones (Owen, Ann. Statist. 25 (1997)
 * 1541-1562).  The random bits are a hash of seed, dimension and digits.
 */
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "status.h"

enum { SOBOL_BITS = 30, SOBOL_DIMENSIONS = 40 };

struct sobol {
    size_t dimensions;
    uint32_t turn[SOBOL_DIMENSIONS][SOBOL_BITS]; /* direction numbers, binary
                                                    digits from bit 29 down */
};

/* For points 0 .. points - 1, at most 2^30, of at most 40 dimensions.
 * STATUS_NO_MEMORY. */
MUST_CHECK enum status sobol_init(struct sobol *s, size_t dimensions,
                                  size_t points);

/* Coordinate `dimension` of a point, in (0, 1), under scrambling `seed`. */
double sobol_at(const struct sobol *s, size_t point, size_t dimension,
                uint64_t seed);

/* A hash of two words, and a number in (0, 1) of 52 random bits. */
uint64_t sobol_hash(uint64_t a, uint64_t b);
double sobol_unit(uint64_t bits);
