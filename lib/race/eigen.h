/*
 * eigen.h -- the stable manifold of a saddle once more, by a route that shares
 * nothing with grow.h but the field: no jets, an explicit Runge-Kutta method,
 * other coordinates, another start and another end.
 *
 * In eigen-coordinates W = (X, Y) (eigen_frame.h) the manifold is Y = S(X),
 * S(0) = S'(0) = 0, S' = Ydot/Xdot, (37).  Far out S' -> -1, where neither X
 * nor Y is singled out, so the curve is followed in its arc length s in the
 * (X, Y) plane: dW/ds = -Wdot/|Wdot|; and where z has become a small difference
 * of large X and Y, in its arc length in the plane of z.
 */
#ifndef RACE_EIGEN_H
#define RACE_EIGEN_H

#include "branch.h"
#include "eigen_frame.h"
#include "monitor.h"

struct eigen_options {
    double rtol;      /* asked of the limits and integrals */
    size_t max_steps; /* of each of two runs */
    struct carry carry;
    const struct monitor *monitor; /* borrowed, may be NULL */
};

struct eigen_options eigen_defaults(double rtol);

/* The half of the stable manifold with X > 0 (side +1: towards larger x;
 * larger y where it leaves the saddle vertically) or X < 0 (side -1), of the
 * saddle `e` at sys->origin; uses sys->field and sys->rate_gradient only.
 * Limits and totals come from a run with a tenth of rtol; errors also from its
 * difference to a second run, a hundred times coarser and from another start;
 * they are infinite where the two end differently; they bound the whole error:
 * steps, start, end and rounding of the curve, not of the field.  That of a
 * piece: of the coordinate the curve is flatter in, from errors made so far and
 * what the field makes of them (eigen_drift.h).
 * STATUS_BAD_ARGUMENT: rtol not in (0, 1), side not +-1, too much to carry, the
 * saddle outside sys->domain;
 * STATUS_NOT_HYPERBOLIC: `e` has no such manifold, or equilibrium_is_beyond;
 * STATUS_NO_CONVERGENCE: no start is near enough, or no step is short enough;
 * STATUS_STOPPED; STATUS_NO_MEMORY.  On error *out is empty. */
MUST_CHECK enum status eigen_branch(const struct planar *sys,
                                    const struct equilibrium *e, int side,
                                    const struct eigen_options *o,
                                    struct branch *out);

#endif
