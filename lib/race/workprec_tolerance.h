/* workprec_tolerance.h -- the tunable numbers of work-precision diagrams. */
#pragma once

/* Truth: error of a step of a 113-bit branch, relative to its offset; and of
 * 113-bit orbits (quad_orbit.h), whose ends are then good to 1e-20 (measured:
 * tighter ones agree to 1e-21). */
#define WORKPREC_CURVE_TOL 1e-22
#define WORKPREC_ORBIT_TOL 1e-10

/* Rows cut a branch no nearer the saddle than this, in ln v, and at an angle
 * with at least this sine. */
#define WORKPREC_ROW_NEAREST 0.01
#define WORKPREC_ROW_ACROSS  0.1

/* Integrators: part of the tolerance that is left out at an end, and missed at
 * a row or at arrest, or at the start; longest branch, in ln v and ln psi;
 * first steps, in distances from the saddle and over the fastest rate. */
#define WORKPREC_REST     0.1
#define WORKPREC_MISSED   0.01
#define WORKPREC_LONGEST  2000.0
#define WORKPREC_FIRST    0.1
#define WORKPREC_CAUTIOUS 1e-3

/* Evaluations after which an integrator has failed: what every user gives up
 * at; for the quick race. */
#define WORKPREC_CALLS       600000
#define WORKPREC_CALLS_QUICK 20000

/* Seconds spent on repeating one run for its time, at most so often, in batches
 * of at least so many seconds, a thousand ticks of the clock. */
#define WORKPREC_SECONDS       0.03
#define WORKPREC_SECONDS_QUICK 1e-3
#define WORKPREC_REPEATS       25
#define WORKPREC_BATCH         4e-5

/* A run that says it succeeded failed silently if its error is above its own
 * bar; or, where it has none, above SILENT times its tolerance (and FLOOR, what
 * rounding may leave of a double), times FAIR, for integrators hold the error
 * of a step, and errors of hundreds of steps add up; or above WRONG, which is
 * no answer. */
#define WORKPREC_SILENT 100.0
#define WORKPREC_FAIR   10.0
#define WORKPREC_WRONG  0.1
#define WORKPREC_FLOOR  1e-14

/* Errors below are drawn and compared as this. */
#define WORKPREC_LEAST 1e-17
