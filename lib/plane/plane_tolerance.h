/* plane_tolerance.h -- the tunable numbers of planes of formulas. */
#pragma once

#include "tolerance.h"

/* Planes of formulas, distances in sides of the window.  Curves are followed
 * this many windows far, orbits of which nothing is proved so far, where
 * series of doubles still move, this many times round an angle (orbits to
 * TOL_ORBIT_RTOL, which only has to find the right trap); a state that changes
 * no faster, of the fastest rate, rests; of the accuracy that is asked for, a
 * branch gets this part.  What is below TOL_SEEN is not seen: a curve with a
 * larger bar is lost, and so is an orbit so near to an equilibrium where
 * rounding decides; cycles are looked for from so far beside others; a region
 * with so much of the window is small. */
#define TOL_PLANE_PART     0.1
#define TOL_PLANE_FAR      100.0
#define TOL_PLANE_INFINITY 1e12
#define TOL_PLANE_ROUND    1e4
#define TOL_PLANE_STILL    1e-9

/* Orbits of such planes: series in time, or the implicit method once so many
 * steps in turn (TOL_MONITOR_STEPS) are held to little of the window, and to
 * where the velocity changes by little of itself, or TOL_EXPLICIT_STEPS did
 * not bring it round; steps of all orbits, for labels and for audits, where so
 * many crossings of rows with curves, or boxes of a search for an equilibrium,
 * take as long as a step. */
#define TOL_PLANE_WORK      200000
#define TOL_PLANE_CROSSINGS 256
#define TOL_PLANE_BOXES     16

/* Basins of such planes, of cycles that are kept to TOL_RTOL_DEFAULT: states
 * that are followed to look for curves that divide it: a part p of one label
 * that goes elsewhere is missed with odds of about e^(-256 p); copies of a
 * curve of an angle; how much further than before a curve may go in a gap
 * (plane_patch.c); sides of the first and of the last cells of a region that
 * is parted (plane_mosaic.h). */
#define TOL_PLANE_LOOKS 256
#define TOL_PLANE_TURNS 50.0
#define TOL_PLANE_FLAT  16.0
#define TOL_PLANE_CELLS 0x1p-4
#define TOL_PLANE_CELL  0x1p-8

/* Turns (plane_turn.h).  None of these decides whether a turn is a trap, for
 * the boxes do: they bound the work after which a smaller one has to do.  Steps
 * of an orbit for one turn; boxes of one sign that a row, or a divergence, may
 * be parted into; the largest turn is found up to this factor. */
#define TOL_TURN_STEPS  200
#define TOL_TURN_BOXES  500
#define TOL_TURN_FACTOR 1.03

/* Equilibria outside the window that a last look at orbits which came to no end
 * may find: more of them are rows without end, of which no orbit tells more
 * than its own strip. */
#define TOL_PLANE_STRIPS 8

/* Sensitivities: parameters are moved by this part of themselves, so that a
 * difference is off by 1e-18 third derivatives and by 1e9 bars of numbers that
 * are known to 1e-28; the equilibrium is then looked for TOL_BESIDE. */
#define TOL_PLANE_MOVED 0x1p-30
