/*
 * trajectory.h -- orbits of a portrait: forward in time from given starts, or
 * whole orbits spread over the window so that the picture is evenly filled,
 * until each leaves the window by a margin, arrives at a target or meets
 * another of its limits.
 */
#pragma once

#include <stdint.h>

#include "arrival.h"
#include "orbit.h"
#include "window.h"

/* A curve whose components 0 and 1 are offsets from `origin`. */
struct trajectory_drawn {
    const struct curve *curve; /* borrowed */
    struct vec2 origin;
};

struct trajectory_options {
    /* As for a single orbit: targets (equilibria) with the distance that
     * counts as arrival, limits, events.  `window` is ours to set. */
    struct orbit_options orbit;
    double margin; /* >= 0; beyond the window, as a fraction of its sides */
    uint64_t seed; /* of the spread */
    bool halfway;  /* spread orbits start where they were chosen, not where they
                      come in */
    const struct trajectory_drawn *drawn; /* borrowed: what else a spread keeps
                                             away from */
    size_t drawn_count;
    const struct arrival_scale *closes; /* borrowed; NULL: no orbit ends where
                                           it has come back to its start */
    const struct monitor *monitor;      /* borrowed, may be NULL */
};

/* orbit_defaults with the limits of tolerance.h, seed 0. */
struct trajectory_options trajectory_defaults(const struct planar *system,
                                              double kappa);

struct trajectory {
    struct vec2 start;  /* absolute */
    struct curve curve; /* owned; components as in orbit.h; empty where the
                           start is the end */
    enum orbit_end end; /* ORBIT_RUNNING: it has closed, or see status */
    size_t end_index;
    enum status status;          /* STATUS_OK; STATUS_TOO_MANY_STEPS or
                                    STATUS_NO_CONVERGENCE where the orbit was given up:
                                    the curve is valid as far as it goes */
    double error[CURVE_DIM_MAX]; /* sums of the steps' error estimates */
    size_t evaluations;          /* of the field or its Jacobian */
};

struct trajectories {
    struct trajectory *at; /* owned */
    size_t count;
    size_t evaluations; /* all of them, and the choice of the starts */
};

#define TRAJECTORIES_EMPTY ((struct trajectories){ .at = NULL })

/* From start[0 .. count-1] (absolute), in this order.  Runs in parallel; the
 * results do not depend on the number of threads.
 *
 * STATUS_BAD_ARGUMENT: window or a start outside the domain, an option out of
 * range; STATUS_NO_MEMORY; STATUS_STOPPED by the monitor.  On error *out is
 * untouched.  An orbit that fails numerically is no error: see its status. */
MUST_CHECK enum status trajectory_run(const struct planar *system,
                                      const struct window *window,
                                      const struct vec2 start[], size_t count,
                                      const struct trajectory_options *options,
                                      struct trajectories *out);

/* `count` orbits, each through a point as far as can be from those before it,
 * from what is drawn and from the frame's mirror image, and each from where it
 * comes into the window (trajectory.c), or from that point where it is halfway.
 * Otherwise as trajectory_run. */
MUST_CHECK enum status trajectory_spread(
    const struct planar *system, const struct window *window, size_t count,
    const struct trajectory_options *options, struct trajectories *out);

/* A second call is harmless. */
void trajectory_free(struct trajectories *t);
