/* numbers_tolerance.h -- the tunable numbers of lib/numbers. */
#pragma once

#include "friction_tolerance.h"
#include "tolerance.h"

/* Sensitivities (sensitivity.c).  The finer run's is TOL_PART of what is asked
 * for, down to TOL_FINEST (the coarser one's is TOL_RTOL_DEFAULT at
 * least, lest the two be the same run); Gauss points a piece of the two
 * (measured: 8 leave 1e-13). */
#define TOL_VARIATION_NODES 10
#define TOL_VARIATION_FEWER 7

/* Bars: e-folds that what is left at the end may take to decay; above this
 * part of the value it never does.  Of the bar of the saddle's place
 * TOL_FAR_BELOW is felt (measured: 1/4000). */
#define TOL_VARIATION_REST 10.0
#define TOL_VARIATION_OPEN 1e-9

/* Curves of steady states (steady_curve.c, spring_curve.c, fold_curve.c),
 * and chi over the window (chi_curve.c).
 * Points: more than there are 2 px on an axis of 600, most of them where one
 * sees them; an even step from 1e-4 to 1e4 has its decades among them. */
#define STUDY_CURVE_POINTS  401
#define STUDY_SPRING_POINTS 801

/* The saddle's place (place.c).  Numbers go like powers of v_sp, below this one
 * but where places are not known to a rounding.  The tolerance of both runs is
 * TOL_EXTREMUM_REACH of the way from the first place to the second, over which
 * they bend as little as mu_ss. */
#define TOL_PLACE_POWER 8.0
