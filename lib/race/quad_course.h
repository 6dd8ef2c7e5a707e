/*
 * quad_course.h -- a 113-bit orbit on its way: clock, steps, and steps taken
 * again to a part of themselves.  For quad_orbit.c.
 */
#pragma once

#include "quad_orbit.h"
#include "rescaled.h"

/* Components: offsets from the anchor, and what has passed so far. */
enum { QUAD_X, QUAD_Y, QUAD_TIME, QUAD_SLIP, QUAD_WORK, QUAD_DIM };

/* Where the orbit is, and what it met on the way, which is the caller's to
 * fill: peaks, fate, and what is left. */
struct quad_course {
    const struct quad_slope *slope;
    double tol;
    struct rescaled clock;
    quad u[QUAD_DIM], du[QUAD_DIM]; /* where it is, and the rates there */
    quad h;                         /* of the next step */
    struct quad_radau last;
    quad pace; /* of the clock now, of that of `last`; 0: no last step */
    quad bend; /* of the next step (quad_radau.h) */
    double excess, trend;   /* of the last step; its length over that before */
    size_t steps, failures; /* tried; equations that were not solved */
    quad v_peak, mu_peak;
    double rise[2]; /* rates of v and mu where it is */
    enum fate fate;
    bool is_over; /* though its fate may not be known */
    size_t falls; /* steps since v can but fall to 0 */
    quad left[2]; /* time and slip not followed: within their errors */
};

/* At the absolute chart point (x, y). */
void quad_course_start(struct quad_course *c, const struct quad_slope *q,
                       quad x, quad y, double tol);

/* The field at the offset z, on the clock: du[QUAD_X] .. du[QUAD_TIME]. */
void quad_course_field(const struct quad_course *c, const quad z[2], quad du[]);

/* A step w from c to `to` that is short enough; false where none is. */
bool quad_course_take(struct quad_course *c, struct quad_radau *w,
                      quad to[QUAD_DIM], double *excess);

/* The step to the part theta of the last one tried, from the same start. */
bool quad_course_part(const struct quad_course *c,
                      const struct quad_radau *whole, quad theta,
                      struct quad_radau *w, quad to[QUAD_DIM]);

/* Moves to the end of the step w, which was `excess` of what is allowed. */
void quad_course_move(struct quad_course *c, const struct quad_radau *w,
                      const quad to[QUAD_DIM], double excess);
