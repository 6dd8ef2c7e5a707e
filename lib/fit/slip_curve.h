/*
 * slip_curve.h -- friction against slip from critical release distances, (25):
 *
 *     s_k = -K d(l_k tan alpha)/d(tan alpha),     mu(s_k) = tan alpha,
 *
 * the derivative taken on a smoothing spline through the data.
 */
#pragma once

#include "least.h"
#include "record.h"

/* A point of the curve; errors are 95 % bounds. */
struct slip_point {
    double mu;                       /* tan alpha */
    double release, release_error;   /* l_k tan alpha, smoothed */
    double gradient, gradient_error; /* s_k/K, in the unit of l_k */
    struct quantity s_k;             /* in the unit of l_k */
};
extern const struct record_type record_slip_point;

struct slip_curve {
    struct slip_point *at; /* owned; mu ascending, over the data's range */
    size_t count;
    double smoothing;   /* as given, or found */
    double freedom;     /* parameters that the curve spends, 3 to 4 if smooth */
    const char *reason; /* why there is no curve, static, and the two above are
                           NaN; NULL: there is one */
};

/* The cubic spline y(u), u = 0..1 over the data's range of tan alpha, that
 * makes least
 *
 *     mean of (y - l_k tan alpha)^2, weighted by 1/error^2
 *         + smoothing * mean of (y''')^2 over u, weighted by 1/height^2,
 *
 * height being that of a first, unweighted curve:
 * the larger `smoothing` > 0, the nearer to a parabola, which (33) is; 0: found
 * by cross-validation.  Values without errors: as least.h has it.  K: of (22);
 * 0: unknown, and s_k says so.  STATUS_NO_MEMORY, STATUS_NO_CONVERGENCE: *out
 * is empty.  Data at fewer than four slopes are a reason, not an error. */
MUST_CHECK enum status slip_curve_fit(const struct measured *m, double K,
                                      double smoothing, struct slip_curve *out);

/* A second call is harmless. */
void slip_curve_free(struct slip_curve *c);
