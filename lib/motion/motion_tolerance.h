/* motion_tolerance.h -- the tunable numbers of lib/motion. */
#pragma once

#include "numbers_tolerance.h"

/* An orbit that has not arrived after so many times the slowest scale of the
 * steady states has left every scale; below TOL_FAR_BELOW as a power of time it
 * has not. */
#define TOL_FATE_LATE 1e30

/* A next try of an orbit or a cell is so many times finer, looser or nearer, at
 * most; a run to compare with is finer, or looser, by FINER. */
#define TOL_RETRY 100.0
#define TOL_FINER 0.1

/* Labels by forward integration (trap.c), from TOL_COARSEST to
 * TOL_TRANSIENT_FINEST: the distance from the saddle, in tolerances, at which a
 * label is certain: errors of a few hundred steps, grown a hundredfold on the
 * way. */
#define TOL_TRAP_FAR 1e4

/* The same for the distance from the stable manifold where an orbit is caught:
 * a few steps, not magnified. */
#define TOL_TRAP_SIDE 30.0

/* Moments (moment.c).  Below this component of a direction mu is compared with
 * tan(alpha) itself. */
#define TOL_MOMENT_DIRECTION 1e-100

/* A turn of ln v, ln psi or mu along an orbit is one when it is as high as the
 * orbit's tolerance (rounding makes turns a tenth of it high); what
 * rounding does to numbers along an orbit, in units of roundoff, at once and
 * with each step (measured at the finest tolerances: 120 roundings of the time
 * at most). */
#define TOL_TIMELINE_ROUNDING 128.0
#define TOL_TIMELINE_STEP     0.02

/* Orbits of transients (whose events are good to a hundredth of what is asked
 * of them): the finest that helps (looser ones up to TOL_COARSEST, then finer
 * ones are tried where TOL_ORBIT_STEPS do not suffice); where a block runs away
 * or fades, as factors on v; where arrest is looked for at the end of a run
 * that was arrested, in units of its distance; and the ln v (1e-11) down to
 * which a block that rests is followed, at least, or until TOL_NOTHING is left,
 * or a part of what it may be off by makes all of its rates, not to first
 * order. */
#define TOL_TRANSIENT_FINEST 3e-13
#define TOL_TRANSIENT_FAST   1e6
#define TOL_TRANSIENT_SLOW   1e-8
#define TOL_TRANSIENT_REACH  2.0
#define TOL_TRANSIENT_DEEP   (-25.4)

/* Along the curve of a block that comes to rest (rest_curve.c; to a ln v of
 * -TOL_SETTLED): apart in ln v, or in ln psi, for differences. */
#define TOL_REST_DIFFERENCE 0.01

/* What is left of a rest (rest_left.c, rest_lag.c).  The change, as a part,
 * that the last round of an iteration may leave; what the curve may be off,
 * relative, or by rounding beside the time so far, and an orbit from it in ln
 * v; the ln v below which psi is looked for behind psi_ss; bars, beside
 * all time and slip, and the part of the time so far within which a state rests
 * before it lands (landing.c): v would reach zero, and psi infinity, and power
 * laws are far above it.  Panels: the first, in ln psi or ln v; the factor
 * before what both rules differ by that is raised to 3/2 for a bar; and how
 * much better a panel is that is followed by one twice as long. */
#define TOL_REST_SETTLED  1e-9
#define TOL_REST_WRONG    1e-11
#define TOL_REST_SLOW     (-3.0)
#define TOL_REST_GOOD     1e-10
#define TOL_REST_PANEL    0.25
#define TOL_REST_EASY     1e-3
#define TOL_REST_QUADPACK 200.0

/* What part of the change by a tenfold tolerance a bar holds at least. */
#define TOL_FATE_CHANGE 0.2
