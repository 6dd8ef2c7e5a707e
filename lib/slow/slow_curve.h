/*
 * slow_curve.h -- the curve that all orbits of a slope land on, and what is
 * still to come from each of its points.
 *
 * Near its steady states the block forgets a direction far faster than it
 * moves along the other: orbits fall onto one curve x = x_s(y) -- the saddle's
 * unstable manifold, and beyond each node the curve that leads back to it --
 * and follow it to arrest (cells.h).  The curve is an orbit: it is run once,
 * and slip and time to arrest are kept as functions of y.  An orbit c away
 * from it, along the fibre e of the fast rate lambda, arrives together with the
 * point it projects on (Fenichel, J. Diff. Eq. 31, 1979, 53-98).
 */
#pragma once

#include "rest_curve.h"
#include "slow_point.h"

enum { SLOW_BRANCHES = 4 };

struct slow_curve {
    const struct slider *slider; /* borrowed */
    struct slow_branch branch[SLOW_BRANCHES];
    size_t branches;
    struct saddle_series *near; /* owned; NULL: none */
    /* For base points (base_point.h): the insides of the boxes that branches
     * end at, and the saddle's manifold where that runs away; count 0: none. */
    struct slow_branch inside[SLOW_BRANCHES], away;
    struct rest_curve rest; /* where a branch ends at rest in finite time */
    double time_least, slip_least; /* of states outside the boxes of arrest */
    bool rests;     /* a branch, or all beside it, ends at v = 0 */
    bool runs_away; /* v > v_sp, psi < psi_sp holds no node */
};

/* Of s, whose steady states are known.  Branches that do not end at a node or
 * at rest are left out, and so are parts where the rates are too much alike
 * (TOL_FAR_BELOW); there may be none at all.  STATUS_NO_MEMORY,
 * STATUS_STOPPED: *c is empty. */
MUST_CHECK enum status slow_curve_init(struct slow_curve *c,
                                       const struct slider *s,
                                       const struct monitor *monitor);

/* Its point at the offset y; false where there is none. */
bool slow_curve_at(const struct slow_curve *c, double y, struct slow_point *p);

/* The same anywhere: where rates are alike (gap is HUGE_VAL), inside the boxes,
 * with negative time and slip, and on `away`, with those to its end. */
bool slow_curve_anywhere(const struct slow_curve *c, double y,
                         struct slow_point *p);

/* Its point with so much time to come on the way that leads through y, as of
 * slow_curve_anywhere; NaN: there is none. */
double slow_curve_when(const struct slow_curve *c, double y, double time);

/* x and dx/dy alone, which is several times faster; `anywhere`: also on what
 * leads nowhere else (below). */
bool slow_curve_beside(const struct slow_curve *c, double y, bool anywhere,
                       double *x, double *x_slope);

/* A second call is harmless. */
void slow_curve_free(struct slow_curve *c);
