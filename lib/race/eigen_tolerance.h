/* eigen_tolerance.h -- the tunable numbers of the second route. */
#ifndef RACE_EIGEN_TOLERANCE_H
#define RACE_EIGEN_TOLERANCE_H

#include "tolerance.h"

/* The stable manifold in eigen-coordinates (eigen.c).  Step tolerance for a
 * promise of rtol, and that of the second run to compare with. */
#define TOL_EIGEN_STEP   0.1
#define TOL_EIGEN_COARSE 100.0
/* Where the search for a start begins, in X, and the most it shortens it in one
 * attempt: a field may change over 1e-300. */
#define TOL_EIGEN_START   0.25
#define TOL_EIGEN_SHORTEN 0.01
/* A branch has ended when what is left is below this part of rtol, so that
 * the end never dominates the error; at the edge of the domain, which is only
 * where doubles end, this part will do (TOL_LIMIT_DECAY tells whether it
 * ends). */
#define TOL_EIGEN_REST 0.01
#define TOL_EIGEN_EDGE 1e-3
/* A branch without a limit is left where its slope is this slight, and is so
 * this far ahead of it. */
#define TOL_EIGEN_SLIGHT 1e-4
#define TOL_EIGEN_AHEAD  0.1
/* Longest step, in the plane: a few times the width of the narrowest bend
 * between two straight parts. */
#define TOL_EIGEN_LONGEST 8.0
/* Far out, as a part of the way there: as a power of it, slopes then change by
 * little. */
#define TOL_EIGEN_STRIDE 0.05
/* Where z = P W has become this many times smaller than what it is the
 * difference of, W is left for z: steps cannot make up for more. */
#define TOL_EIGEN_LOST 10.0
/* A step is halved where its polynomial is further than this from a solution
 * between its stages, in tolerances: one in a thousand is (measured), most at
 * kinks that a step's estimates miss. */
#define TOL_EIGEN_DEFECT 30.0
/* Where steps fail, points at this part of the distance from the saddle tell
 * whether an equilibrium lies between. */
#define TOL_EIGEN_ODD 1e-8
/* Bars: a part of the steps' estimates (of order 5; measured: true errors stay
 * below a tenth of them where rounding does not rule) and defects; of what the
 * end adds (measured: an exponential through two steps is right to a factor of
 * two). */
#define TOL_EIGEN_ESTIMATES 0.1
#define TOL_EIGEN_RESTS     10.0

#endif
