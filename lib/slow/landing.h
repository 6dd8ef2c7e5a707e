/*
 * landing.h -- an orbit on its way onto the slow curve (fast_layer.h): whether
 * it is there, or its fate is known otherwise, and how far it may go if not.
 */
#pragma once

#include "explicit8.h"
#include "fast_layer.h"

/* Components in arc length of the chart. */
enum { LAYER_X, LAYER_Y, LAYER_TIME, LAYER_SLIP, LAYER_DIM };

/* Terms of a step's series: those of explicit8_table.h, and all from order 4
 * on. */
enum { LANDING_FOURTH = EXPLICIT8_TERMS, LANDING_TERMS };

/* A step of length h: its terms `across` the orbit, to its left, and of time
 * and slip where it has come as far along; by how much rounding moves it
 * across; and what it makes of a unit across at its start: `left` of it, and
 * more of time and slip. */
struct landing_step {
    struct vec2 from;
    double h;
    double across[LANDING_TERMS];
    double time[LANDING_TERMS], slip[LANDING_TERMS];
    double digits;
    double left, time_gain, slip_gain;
};

struct landing {
    const struct slow_curve *curve;
    struct layer_options options;
    struct vec2 from;                   /* its start */
    double u[LAYER_DIM], du[LAYER_DIM]; /* where it is, and per unit of arc */
    struct landing_step *step;          /* borrowed: TOL_LAYER_STEPS */
    double start;                       /* what rounding moves its start by */
    double start_time, start_slip;      /* by as much along it */
    double across; /* how far off the orbit it is by now, at most */
    double time_error, slip_error; /* rounding of what it gained */
    double mu;         /* friction where it is, if peaks are asked for */
    double mu_least;   /* the largest so far is this at least */
    struct layer near; /* what the saddle's series told, if is_near */
    struct layer *out;
};

static inline struct vec2 landing_place(const struct landing *l)
{
    return (struct vec2){ l->u[LAYER_X], l->u[LAYER_Y] };
}

static inline struct vec2 landing_way(const struct landing *l)
{
    return (struct vec2){ l->du[LAYER_X], l->du[LAYER_Y] };
}

/* At the offset z, with *out as of an orbit that is lost; du and step are the
 * caller's to fill.  least: what errors of time and slip are relative to at
 * least. */
void landing_start(struct landing *l, const struct slow_curve *c, struct vec2 z,
                   const struct layer_options *options, struct layer *out,
                   double least[2]);

/* True: *out is known, but for steps and calls.  False: *most is the longest
 * next step, which is to be taken as it is where it is negative. */
bool landing_is_over(struct landing *l, double *most);

/* Whether a step to u goes through the face of a box of arrest. */
bool landing_is_past(const struct landing *l, const double u[]);
