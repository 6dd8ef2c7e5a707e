/*
 * rest_curve.h -- the curve along which a block comes to rest: v vanishes in a
 * finite time while psi follows psi_ss(v) without bound, settling the faster
 * the smaller v is.
 *
 * It is where the saddle's unstable manifold goes after psi has become the fast
 * coordinate (slow_curve.h is where v is), a graph y = y_s(x) over ln v.  Far
 * down psi = psi_ss(v), and by (17) time and slip to rest are
 *     T = int_0^inf w(x - u) du,  X = int_0^inf v w du,  w = -1/(d ln v/dt)
 *       = eps^2 v / (cos(alpha) mu - sin(alpha)).
 */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "monitor.h"
#include "planar.h"
#include "status.h"

struct slider;

/* One point, an offset from the system's origin; slopes per unit of x. */
struct rest_point {
    double x, y, y_slope;
    double time, slip; /* to rest, units of L/V_star and L */
    double time_slope, slip_slope;
    double time_error, slip_error; /* absolute, of the table */
    double fast;                   /* the rate psi settles at */
    double gap;                    /* the slow rate over it, < 1 */
    struct vec2 fibre;             /* unit */
};

struct rest_knot {
    struct rest_point at;
    double y_bend;               /* d2y/dx2 */
    double time_bend, slip_bend; /* second derivatives by x */
    double time_bar, slip_bar;   /* of at.time and at.slip; at.*_error: of the
                                    polynomials between it and the next */
};

struct rest_curve {
    const struct slider *slider; /* borrowed */
    struct rest_knot *knot;      /* owned; x falls */
    size_t count, room;
};

/* By the orbit from the offset z, which comes to rest.  Where it does so in
 * another way the curve is empty.  STATUS_NO_MEMORY, STATUS_STOPPED; *c is to
 * be freed in any case. */
MUST_CHECK enum status rest_curve_run(const struct slider *s, struct vec2 z,
                                      const struct monitor *monitor,
                                      struct rest_curve *c);

/* y and dy/dx at the offset x, however far down; false above its start. */
bool rest_curve_beside(const struct rest_curve *c, double x, double *y,
                       double *y_slope);

/* All of it. */
bool rest_curve_at(const struct rest_curve *c, double x, struct rest_point *p);

/* A second call is harmless. */
void rest_curve_free(struct rest_curve *c);
