/* turning.h -- where a polynomial on [0, 1] turns. */
#pragma once

#include "jet.h"

/* Twice as many points as a series has turns are room enough. */
enum { TURNING_MAX = 2 * JET_SIZE };

/* The p(theta) = sum_k c[k] theta^k of degree < JET_SIZE: bounds of p on
 * [0, 1], by the convex hull of its Bernstein coefficients. */
struct turning_range {
    double lo, hi;
};
struct turning_range turning_bound(size_t degree, const double c[]);

/* Points in (0, 1), ascending, between which p is monotone; more of them where
 * digits do not tell.  Returns how many, at most TURNING_MAX. */
size_t turning_find(size_t degree, const double c[], double at[TURNING_MAX]);
