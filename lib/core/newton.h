/*
 * newton.h -- the root of a scalar function in a bracket: interpolation steps
 * of Newton's kind, safeguarded by bisection, so that they never leave it.
 */
#pragma once

#include <stddef.h>

#include "status.h"

/* The function changes sign within `error` of x; x is the end of the last
 * bracket with the smaller value.  error = 0: the function is zero at x. */
struct newton_root {
    double x, error;
    size_t calls;
};

struct newton_root_long {
    long double x, error;
    size_t calls;
};

/* A sign change of f in [lo, hi], where f(lo) and f(hi) must differ in sign
 * or one of them be zero; infinite values count by their sign.  Stops when
 * the bracket is at most `tol` wide or its ends are adjacent numbers, so
 * tol = 0 asks for all there is.  Calls: about 10 for smooth f, never more
 * than 4 times those of bisection.
 *
 * STATUS_BAD_ARGUMENT: lo > hi or no sign change; STATUS_NO_CONVERGENCE: f
 * is NaN somewhere.  Either leaves *out untouched. */
MUST_CHECK enum status newton_find(double (*f)(const void *ctx, double x),
                                   const void *ctx, double lo, double hi,
                                   double tol, struct newton_root *out);

/* The same in long double. */
MUST_CHECK enum status newton_find_long(long double (*f)(const void *ctx,
                                                         long double x),
                                        const void *ctx, long double lo,
                                        long double hi, long double tol,
                                        struct newton_root_long *out);

/* The same between x[0] <= x[1], where it is at[0] and at[1]; tol = 0. */
MUST_CHECK enum status newton_close_long(
    long double (*f)(const void *ctx, long double x), const void *ctx,
    const long double x[2], const long double at[2],
    struct newton_root_long *out);
