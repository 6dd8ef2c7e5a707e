/*
 * fast_layer.h -- states fall onto the slow curve (slow_curve.h): slip, time
 * and peaks from there to their arrest, by explicit steps on the way down and
 * the curve's table for the rest.  Many states go side by side, each in a lane
 * of its own (lanes.h), with steps of its own; a lane whose state has landed
 * takes the next.
 */
#pragma once

#include <stddef.h>

#include "slow_curve.h"

enum layer_end {
    LAYER_LANDED,
    LAYER_RESTED, /* v = 0 before it landed */
    LAYER_RAN,    /* into v > v_sp, psi < psi_sp, where no node is */
    LAYER_UNSURE, /* landed, but on this side of the saddle only perhaps */
    LAYER_LOST    /* none of these */
};

/* How to follow one. */
struct layer_options {
    double promise;    /* relative, of time and slip */
    double rtol;       /* of each step, absolute in ln v and ln psi */
    double landing;    /* from the slow curve, in ln v */
    double time, slip; /* about what is to come, if less than that of any state
                          outside the boxes of arrest; 0: not known */
    bool peaks;
    bool through; /* boxes of arrest, and not told that it runs away as long as
                     it may land: for its base point (base_point.h); time and
                     slip are then negative inside a box */
};

/* The largest value of an orbit: that of a point known to within `error`; all
 * others are at most `most`. */
struct layer_peak {
    double value, error, most;
};

/* Values as of struct cell; errors absolute. */
struct layer {
    enum layer_end end;
    int8_t fate;
    double time, time_error;
    double slip, slip_error;
    double x_end; /* ln(v/v0) at arrest; -HUGE_VAL: v = 0 */
    double x_end_error;
    /* where on the slow curve it landed, NaN: elsewhere; the errors of time,
     * and of slip less as much at that place, but for the table's */
    double y, way_time_error, way_slip_error;
    /* told by the saddle's series: y, with its error, is then where its base
     * point is, and `more` its slip beyond that of y, with way_slip_error */
    bool is_near;
    double y_error, more;
    struct layer_peak x, mu; /* of ln(v/v0) and friction */
    double place_error;      /* of a point of the orbit, in ln v and ln psi */
    bool falls[2];           /* ln v and mu do at the start */
    double mu_next; /* the largest mu at an end of a step, but for the start */
    size_t steps, calls;
};

struct layer_options layer_defaults(double rtol);

/* One state: its offset in the curve's system, and how to follow it. */
struct layer_job {
    struct vec2 z;
    struct layer_options options;
};

/* How many lanes at once: 8 or 4 where the processor has them, else 2, or 1; at
 * most `most`. */
int layer_width(int most);

/* job[i] into out[i]; `width`: as of layer_width.  Never fails: out[i] says
 * whether it landed; of one that is lost nothing else is known, of one that ran
 * the fate alone.  It is the same to the bit at any width and whatever the
 * other jobs are. */
void layer_follow(const struct slow_curve *c, int width,
                  const struct layer_job job[], size_t n, struct layer out[]);
