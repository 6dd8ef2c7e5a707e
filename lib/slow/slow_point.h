/*
 * slow_point.h -- one point of a slow branch (slow_branch.h), and which point
 * has so much time left.
 */
#pragma once

#include "slow_branch.h"

/* Per unit of y where it says slope. */
struct slow_point {
    int8_t fate;
    double x, x_slope; /* offset from the system's origin */
    double aside;      /* how far x is off, at this y */
    double time, slip; /* to arrest, units of L/V_star and L */
    double time_slope, slip_slope;
    double time_error, slip_error; /* absolute, of the table */
    double time_less, slip_less;   /* by how much that is less at y itself than
                                      in the middle between two knots */
    double fast;                   /* |lambda|, per unit of time */
    double gap;                    /* the slow rate over it; HUGE_VAL: not to
                                      land on */
    struct vec2 fibre;             /* unit */
    double turns;                  /* how much it does on the interval */
    double swing;                  /* how far off it is, at most */
    double x_end, x_end_error;     /* at arrest; -HUGE_VAL at rest */
    double end_slope;              /* time_slope there; 0 at rest */
    double end_aside;              /* |end_aside.x| of the branch */
    double x_peak, mu_peak;        /* largest from some later point on */
    double folds, x_folds, mu_folds; /* as of a knot, but from here on */
    double mu_near, mu_y; /* largest on the interval around it; where */
    double mu_error, mu_peak_error; /* of mu on it, and of mu_peak */
};

/* The branch's point at the offset y.  False: y is not on the branch, nor
 * between it and the steady state it starts or ends beside. */
bool slow_point_at(const struct slow_branch *b, double y, struct slow_point *p);

/* x and dx/dy alone, of points that may be landed on; false elsewhere. */
bool slow_point_beside(const struct slow_branch *b, double y, double *x,
                       double *x_slope);

/* The y whose time is this, to rounding; NaN: there is none. */
double slow_point_when(const struct slow_branch *b, double time);
