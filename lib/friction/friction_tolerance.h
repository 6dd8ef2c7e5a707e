/* friction_tolerance.h -- what is asked of laws of formulas, which say nothing
 * of themselves.  mu is of the order of 1. */
#pragma once

#include "tolerance.h"

/* ---- steady friction, law_extrema.c -------------------------------------- */

/* |d mu_ss/d ln v| below this is none: 2^-112 times terms of up to 1e13, which
 * cancel where a law does not weaken with v at all. */
#define TOL_SLOPE_LEAST 1e-20
/* ln v, small beside the distances of one over which mu_ss changes: apart for a
 * second derivative of it; by so much the slope at a step's end may be of the
 * wrong sign, rounding of the slope over its curvature; and so far inside the
 * end of its range mu_ss is looked at. */
#define TOL_EXTREMUM_REACH 1e-3L
/* ln v: how near long doubles find an extremum, or 113 bits look further. */
#define TOL_EXTREMUM_ASIDE 5e-7

/* ---- friction as psi grows, quasistatic_typed.c -------------------------- */

/* dpsi/dt is linear where its second difference is below this part of it: 2^-52
 * times a condition of 1e5. */
#define TOL_LINEAR 1e-10
/* A rate without its exponential is of some sign above TOL_TOUCH, as near to 0
 * as some thousand roundings come. */

/* p = -dh/d ln psi of an integral of e^h dpsi, by the last three doublings p,
 * q, r.  It has settled where |p - q| <= TOL_LITTLE max(1, |p|) and this
 * falls, to TOL_POWER_FALL of |q - r| or less, but for TOL_SAME; it
 * grows where each is TOL_POWER_GROWTH times the one before and |p| is clearly
 * above 1. */
#define TOL_POWER_FALL   0.75
#define TOL_POWER_GROWTH 1.3
/* The integral ends if p > 1: surely where |p - 1| is above this; else
 * e^h = 1/(psi ln^s psi), which ends if s > 1: surely where |s - 1|
 * is TOL_CLEARLY. */
#define TOL_POWER_ONE 0.02

/* Inertia cannot hold v back where it is e^-TOL_INERTIA_LN of the forces at the
 * anchor. */
#define TOL_INERTIA_LN 20.0
/* Friction above this is past all bounds. */
#define TOL_FRICTION_MOST 100.0
