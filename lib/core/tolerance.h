/*
 * tolerance.h -- every tunable number of Slipway: default, unit, reason.
 * No algorithm has a literal tolerance of its own.
 */
#ifndef CORE_TOLERANCE_H
#define CORE_TOLERANCE_H

/* Relative error asked for when the scene does not say (dimensionless):
 * what double precision can hold with a margin for the bars. */
#define TOL_RTOL_DEFAULT 1e-12

/* Range of v (and of psi where it is positive), dimensionless: ln of 1e300. */
#define TOL_LN_RANGE 690.7755278982137
/* Range of psi where psi is itself a logarithm. */
#define TOL_PSI_RANGE 700.0

/* Trajectories, relative error per unit of ln v, ln psi: an order-5 method
 * costs four times more per two digits; figures and energy balances to nine
 * digits are plenty. */
#define TOL_ORBIT_RTOL 1e-9

/* An orbit has arrived when it is this near an equilibrium, in both ln v and
 * ln psi: one per cent is what friction experiments resolve. */
#define TOL_ARREST 0.01

/* Bound on the steps of any one integration: a hang is worse than an error. */
#define TOL_MAX_STEPS 1000000

/* Taylor series along a manifold: order (16 to 28 tie in speed), and the
 * tolerance of one step for a promise of rtol on the result: step errors add
 * up over some fifty steps. */
#define TOL_TAYLOR_ORDER 22
#define TOL_TAYLOR_STEP  0.01
/* Never a series start further than this from the saddle, in ln v or ln psi:
 * beyond, the defect at the two ends no longer speaks for the middle. */
#define TOL_SERIES_RADIUS_MAX 2.0
/* A step is kept when the series' slope agrees with the field's at its end to
 * this many times its tolerance: a derivative loses a factor of the order. */
#define TOL_SLOPE_CHECK 300.0
/* Slope |dy/dx| above which x becomes the unknown, and below which y does
 * again: apart, so that the choice does not flip back and forth. */
#define TOL_SLOPE_STEEP 4.0
#define TOL_SLOPE_FLAT  0.3
/* A branch is closed by quadrature when what is left of it is below this,
 * relative to min(1, unknown): eight Laguerre nodes then give 1e-14. */
#define TOL_TAIL 1e-8
/* Longest Taylor step, in the independent coordinate. */
#define TOL_STEP_MAX 50.0

#endif
