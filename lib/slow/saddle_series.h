/*
 * saddle_series.h -- time and slip around a saddle, as power series.
 *
 * With the curve x = x_u(y) that leaves the saddle, every state near it is y
 * and w = x - x_u(y).  There is one function p = y + ... of both that grows
 * like e^(lambda t) along every orbit, lambda the positive eigenvalue: orbits
 * of equal p arrive together, and p = 0 is the separatrix.  What is still to
 * come is therefore, but for constants on either side, exactly
 *
 *     time = -ln|p|/lambda,     slip = v time + q,
 *
 * v the saddle's slip rate, q another power series of y and w (Sternberg, Am.
 * J. Math. 79, 1957, 809-824; only sums a lambda = b |lambda_minus| of powers a
 * of y and b of w stand against it, which end the series before them).
 */
#pragma once

#include <stddef.h>

#include "plane.h"
#include "status.h"

struct slider;

enum { SADDLE_ORDER = 14, SADDLE_SIZE = SADDLE_ORDER + 1 };

/* Coefficients of w^b y^a, both in `unit`. */
typedef double saddle_coefs[SADDLE_SIZE][SADDLE_SIZE];

struct saddle_series {
    double unit;
    double lambda, lambda_error; /* the error is relative */
    double fast;                 /* |lambda_minus| */
    double v;
    size_t order, mixed;       /* of y alone; of both */
    double curve[SADDLE_SIZE]; /* x_u */
    saddle_coefs p, q;
    double rounding;       /* relative, of p */
    double radius;         /* of y/unit on the curve that they hold for */
    double reach;          /* of y/unit and w/unit off it */
    double p_last, q_last; /* sums of the coefficients of the last order */
};

/* At one point: what is added to the slip is in units of L. */
struct saddle_point {
    double x, x_slope;  /* of the curve, at y */
    double p, p_x, p_y; /* in units of y */
    double q, q_x, q_y;
    double p_error, q_error; /* absolute */
};

/* Of the saddle of s.  STATUS_NOT_HYPERBOLIC, STATUS_NO_CONVERGENCE: there is
 * no such curve, or no radius is small enough. */
MUST_CHECK enum status saddle_series_find(const struct slider *s,
                                          struct saddle_series *out);

/* On the curve, |y| <= radius. */
struct saddle_point saddle_series_on(const struct saddle_series *u, double y);

/* x of the curve, and dx/dy. */
double saddle_series_x(const struct saddle_series *u, double y, double *slope);

/* At the offset z; false where the series do not hold. */
bool saddle_series_at(const struct saddle_series *u, struct vec2 z,
                      struct saddle_point *out);

/* The y of the curve with that p, |p| at most a little above that of the
 * radius. */
double saddle_series_y(const struct saddle_series *u, double p);
