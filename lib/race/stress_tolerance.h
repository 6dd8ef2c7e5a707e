/* stress_tolerance.h -- the tunable numbers of the catalogue of stiff and
 * extreme cases. */
#pragma once

/* Each so many cases of the catalogue make the quick one: some 20 seconds; a
 * prime, so that it takes some of every family, law and value. */
#define STRESS_QUICK 23

/* Accuracy asked of critical numbers: as much as doubles hold; and of orbits,
 * whose ends are all that is asked for. */
#define STRESS_RTOL       1e-14
#define STRESS_STATE_RTOL 1e-8

/* Side of a grid of labels, and how many of them an orbit checks. */
#define STRESS_CELLS 24
#define STRESS_AUDIT 40

/* Accuracy asked of fields, of the separatrix beside which they are looked at,
 * and how many cells of a user's grid are. */
#define STRESS_FIELD_RTOL 1e-9
#define STRESS_PLACE_RTOL 1e-12
#define STRESS_LOOKS      64
/* Of 113-bit orbits: good for every bar of a double (quad_orbit.h). */
#define STRESS_ORBIT_TOL 1e-10
/* No separatrix is known worse than that times 1 + |x| + |y| in the chart: a
 * state so far from it has a fate. */
#define STRESS_NEAR 1e-12

/* Error of a step of a 113-bit branch: good for every bar of a double. */
#define STRESS_ORACLE_TOL 1e-18
/* Offset from the saddle, over 1 + psi, at which rates are differenced in 113
 * bits: the field is known relatively there, so that nothing cancels. */
#define STRESS_ORACLE_NEAR 1e-20
/* The oracle settles a number that it knows to this part of its bar. */
#define STRESS_SETTLED 0.1

/* Digits a double may have, and how many fewer than conditioning allows still
 * count as all of them. */
#define STRESS_DIGITS  15.95
#define STRESS_MISSING 2.0

/* Systems of formulas, in windows: steps of branches and of orbits that only
 * have to arrive; a way begins so far from its saddle, off its branch by the
 * square of that, and is compared from so far on; their equilibria are known in
 * 113 bits to so much, of the fastest rate their eigenvalues (differences of
 * 2^-38); an orbit has gone for good. */
#define STRESS_WAY_STEP  1e-22
#define STRESS_ARRIVED   1e-14
#define STRESS_WAY_LEFT  1e-11
#define STRESS_WAY_NEAR  1e-10
#define STRESS_WAY_TOL   1e-25
#define STRESS_SLOPE_TOL 1e-17
#define STRESS_GONE      1e3
