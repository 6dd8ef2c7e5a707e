/*
 * orbit.h -- one orbit of a planar system, forward or backward in time, with
 * time and the observables' integrals as components, by the L-stable method
 * of radau.h on the clock of rescaled.h.
 */
#pragma once

#include "drift.h"
#include "event.h"
#include "monitor.h"
#include "rescaled.h"

struct orbit_options {
    double kappa; /* > 0: the rate, per unit of time, of the fastest decay
                     onto slow curves, e.g. the stable rate of the saddle.
                     Slower motions are resolved in time, faster ones in arc
                     length.  A kappa far too small costs steps, not digits. */
    double rtol;  /* > 0: absolute in x and y (logarithms), relative to the
                     largest value so far in time and integrals */
    double least[1 + PLANAR_OBSERVABLES_MAX]; /* >= 0; time and integrals below
                                                 this need no more digits */
    bool backward;
    bool far; /* rtol of x and y relative to them where they are above 1 */
    size_t observables; /* the first so many are integrated */

    /* Where to stop; the domain of the system stops every orbit. */
    const struct box *window;  /* absolute, borrowed; NULL: none */
    const struct vec2 *target; /* offsets, borrowed */
    size_t targets;
    double arrival;                           /* > 0: |dx|, |dy| <= this */
    double reach[1 + PLANAR_OBSERVABLES_MAX]; /* time, then integrals, signed;
                                                 not 0; INFINITY: no stop */
    const struct event *event;                /* borrowed; u as the curve's */
    size_t events;
    struct drift *drift; /* borrowed; set at the start, and carried on with
                            every step.  NULL: nobody asks */
    size_t max_steps;    /* accepted and rejected */
};

/* Tolerances of tolerance.h, all observables, nothing to stop at. */
struct orbit_options orbit_defaults(const struct planar *system, double kappa);

enum orbit_end {
    ORBIT_RUNNING,
    ORBIT_LEFT_DOMAIN,
    ORBIT_LEFT_WINDOW,
    ORBIT_ARRIVED, /* within reach of target number end_index */
    ORBIT_REACHED, /* reach[end_index]; |t| = TOL_RANGE counts as [0] */
    ORBIT_EVENT,   /* a stop event, number end_index */
};

/* Components: x, y (offsets), t, integrals.  Must not move in memory. */
struct orbit {
    struct orbit_options options;
    struct rescaled clock;
    struct curve curve;      /* owned; dim = 3 + observables, degree 5; error
                                of a piece: the larger of error[0], error[1]
                                at its end */
    struct event_log log;    /* owned; its s is the rescaled time */
    double u[CURVE_DIM_MAX]; /* end of the curve */
    double tau;              /* rescaled time there, negative backward */
    enum orbit_end end;
    size_t end_index;
    size_t steps, rejected, field_calls, jacobian_calls;
    double error[CURVE_DIM_MAX]; /* sum of the steps' error estimates */
    double peak[CURVE_DIM_MAX];  /* largest |u_i| so far */
    double h;                    /* size of the next step in tau, > 0 */
    double du[CURVE_DIM_MAX];    /* at u, per tau */
    struct {
        double h, ratio; /* signed size; error over what is allowed */
    } last;              /* accepted step; h = 0: there is none */
    int refused;         /* attempts in a row that were */
    bool cut;            /* the last attempt went beyond a stop; the next one is
                            to end there */
    struct {
        double x, y, t; /* some steps ago, at step number */
        size_t steps;
        double way; /* how far it has gone since, to and fro */
    } mark;
    double rate; /* of the solution of its equations: radau.h */
};

/* Starts at the offset z with t = 0 and all integrals 0.  A start outside the
 * window or at a target sets o->end at once, and the curve stays empty.
 * STATUS_BAD_ARGUMENT: start not in the domain or an option out of range;
 * nothing to free then, though orbit_free is harmless. */
MUST_CHECK enum status orbit_init(struct orbit *o, const struct planar *system,
                                  struct vec2 z,
                                  const struct orbit_options *options);

/* One accepted step, appended as a piece; the last one is cut where the first
 * stop fired and o->end is set; with options.drift it is taken again to just
 * there, unless that is an event, for the polynomial's errors are the method's
 * at a step's end only.  Afterwards does nothing.
 * STATUS_NO_CONVERGENCE: no step however short is accepted, e.g. where the
 * field is NaN, it goes to and fro in no time, where the field is nothing but
 * rounding, or an integral is above TOL_RANGE; STATUS_TOO_MANY_STEPS;
 * STATUS_NO_MEMORY.  After an error the curve up to o->u is valid. */
MUST_CHECK enum status orbit_step(struct orbit *o);

/* Steps until o->end is set.  Also STATUS_STOPPED, by the monitor (may be
 * NULL). */
MUST_CHECK enum status orbit_run(struct orbit *o,
                                 const struct monitor *monitor);

/* A second call is harmless. */
void orbit_free(struct orbit *o);
