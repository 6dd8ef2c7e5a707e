/*
 * slow_knot.h -- a point of a slow branch (slow_branch.h): the curve and the
 * rates there, and what lies between two of them.
 */
#pragma once

#include <stdbool.h>

#include "orbit.h"

struct slider;

/* How far off a polynomial between two knots is in the middle: it misses so
 * much, and rounding at its ends makes so much of it. */
struct slow_miss {
    double missed, rounded;
};

/* One point of the orbit, an offset from the system's origin. */
struct slow_knot {
    double y, x, x_slope, x_bend;          /* dx/dy, d2x/dy2 */
    double time[3], slip[3];               /* with two derivatives by y */
    struct slow_miss time_miss, slip_miss; /* from the knot before to this */
    double time_bar, slip_bar;             /* from here on */
    double beside;                         /* how far x is off, at this y */
    double aside; /* and at most at any y from the knot before to this one */
    double fast;  /* |lambda|, per unit of time */
    double gap;   /* the slow rate over it; HUGE_VAL: not to land on */
    double fold;  /* the time in which it gets 1/e nearer the curve than
                     what follows that does to it */
    struct vec2 fibre;   /* unit: the eigenvector of |lambda|, then the fibre */
    double swing;        /* how far off that is, at most */
    double mu, mu_error; /* largest on the way to this knot */
    double mu_y;         /* where that is */
    double x_peak, mu_peak, mu_peak_error; /* from here on */
    double folds;             /* the integral of fast from here to the end */
    double x_folds, mu_folds; /* to x_peak, and to the interval of mu_peak, less
                                 ln of what x, and friction, is off there where
                                 the orbit is one off along the fibre */
};

/* At the offset u = (x, y) of the slider's system, with the slope dx/dy of the
 * orbit: all but the values of time and slip, what is summed along the way, and
 * the peaks. */
void slow_knot_at(const struct slider *s, const double u[], double slope,
                  struct slow_knot *k);

/* How fast the slopes of time and slip change at k, per unit of y, as parts of
 * themselves, and how fast such a part does since the knot f before it (or k,
 * the first): one that vanishes does so at a point. */
double slow_knot_change(const struct slow_knot *f, const struct slow_knot *k);

/* Whether y settles first, not x. */
bool slow_knot_is_fast_y(const struct slow_knot *k);

/* Whether the rates are so far apart that rounding in the fast coordinate shows
 * in the slow one. */
bool slow_knot_is_noisy(const struct slow_knot *k);

/* x on the curve from f to g, theta of the way in y, and dx/dy. */
double slow_knot_x(const struct slow_knot *f, const struct slow_knot *g,
                   double theta, double *slope);

/* The second derivative at k from values and slopes there and on either side,
 * at the distances before < 0 and after > 0, or the other way round. */
double slow_knot_bend(const double f[2], const double k[2], const double g[2],
                      double before, double after);

/* The sixth derivative over 6!, by what the polynomial of degree 5 with those
 * values and slopes misses of a value at y, beside all three: value = p(y) +
 * f^(6)(.)/6! (y (y - before) (y - after))^2, which vanishes only where f^(6)
 * does. */
double slow_knot_sixth(const double f[2], const double k[2], const double g[2],
                       double before, double after, double y, double value);

/* The polynomial of degree 5 with value, slope and curvature f at y = 0 and g
 * at y = h, at theta h; and its slope there. */
double slow_quintic(const double f[3], const double g[3], double h,
                    double theta, double *slope);

/* How far off that polynomial is at theta h, t = theta (1 - theta): what it
 * misses is f^(6)(.)/6! (h^2 t)^3, (4 t)^3 of that in the middle; slopes and
 * curvatures at both ends have the weights h t (1 + t) and (h t)^2/2, together,
 * which are at most 4 t of those in the middle. */
double slow_knot_missed(const struct slow_miss *m, double theta);

/* How far off in y a state lands that is right in its slow coordinate, beside a
 * curve that is off by dx. */
double slow_knot_shift(const struct slow_knot *k, double dx);

/* What rounding its place is along the curve, in y: along the fibre, or across
 * the curve where rates are alike: a standard deviation. */
double slow_knot_digit(const struct slow_knot *k);

/* What a component of an orbit gained on its last step, whatever it was before.
 */
double slow_knot_gained(const struct orbit *o, size_t i);
