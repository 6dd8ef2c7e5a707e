/*
 * landing.h -- an orbit on its way onto the slow curve (fast_layer.h): whether
 * it is there, or its fate is known otherwise, and how far it may go if not.
 */
#ifndef SLOW_LANDING_H
#define SLOW_LANDING_H

#include "fast_layer.h"

/* Components in arc length of the chart. */
enum { LAYER_X, LAYER_Y, LAYER_TIME, LAYER_SLIP, LAYER_DIM };

struct landing {
    const struct slow_curve *curve;
    struct layer_options options;
    struct vec2 from;                   /* its start */
    double u[LAYER_DIM], du[LAYER_DIM]; /* where it is, and per unit of arc */
    /* what steps have missed so far: across the orbit, and of what it gained */
    double across, time_error, slip_error;
    double late[2]; /* time and slip of the start's rounding along the orbit */
    struct layer near; /* what the saddle's series told, if is_near */
    struct layer *out;
};

/* At the offset z, with *out as of an orbit that is lost; du is the caller's to
 * fill.  least: what errors of time and slip are relative to at least. */
void landing_start(struct landing *l, const struct slow_curve *c, struct vec2 z,
                   const struct layer_options *options, struct layer *out,
                   double least[2]);

/* True: *out is known, but for steps and calls.  False: *most is the longest
 * next step, which is to be taken as it is where it is negative. */
bool landing_is_over(struct landing *l, double *most);

/* Whether a step to u goes through the face of a box of arrest. */
bool landing_is_past(const struct landing *l, const double u[]);

/* Adds to *out what no estimate sees, of what it gained and of how far it moved
 * across on the way, where time and slip have these slopes.  What steps of
 * order 8 miss of their estimates of order 5 goes like the cube of a step,
 * whose eighth power is its tolerance. */
void landing_add_least(const struct landing *l, double time_slope,
                       double slip_slope, double moved);

#endif
