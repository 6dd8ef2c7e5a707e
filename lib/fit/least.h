/*
 * least.h -- nonlinear least squares with honest weights, by GSL.
 *
 * Values without errors are taken to scatter by one unknown part of
 * themselves: weights are then 1/fitted value^2, found by fitting again, for
 * weights from the noisy values themselves would pull the curve down; and the
 * part is estimated from what is left over.
 */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "status.h"

enum { LEAST_MAX = 3 }; /* parameters */

/* What was measured; all borrowed. */
struct measured {
    const double *x;     /* tan alpha */
    const double *value; /* > 0 */
    const double *error; /* > 0: one standard deviation; NULL: unknown */
    size_t count;
};

/* The curve and its derivatives by the parameters at x. */
typedef void least_model(const void *ctx, double x, const double p[],
                         double *value, double gradient[]);

struct least {
    size_t parameters;   /* on input, at most LEAST_MAX */
    double p[LEAST_MAX]; /* on input where to start, on output the best */
    double covariance[LEAST_MAX][LEAST_MAX];
    double chi2;     /* sum of squares in units of the errors (relative) */
    size_t freedom;  /* points less parameters */
    double scatter;  /* relative, of one value; NaN where errors were given */
    double quantile; /* the 95 % interval of a parameter is p +- this many
                        standard deviations: normal's, or Student's where the
                        scatter is estimated */
    double chance;   /* of a chi2 as large or larger; NaN without errors */
};

/* Needs as many different x as parameters, and one point more where errors are
 * unknown.  Starts should be of the order of one.  STATUS_BAD_ARGUMENT for
 * fewer points, STATUS_NO_CONVERGENCE, STATUS_NO_MEMORY; *fit is then
 * undefined. */
MUST_CHECK enum status least_fit(least_model *model, const void *ctx,
                                 const struct measured *m, struct least *fit);

/* The weighted straight line through the data, to start from; weights as
 * least_fit's first. */
struct least_line {
    double at_zero, slope;
};
MUST_CHECK enum status least_line(const struct measured *m,
                                  struct least_line *line);

/* Whether so many (at most LEAST_MAX + 1) values of x differ. */
bool least_has_places(const struct measured *m, size_t places);
