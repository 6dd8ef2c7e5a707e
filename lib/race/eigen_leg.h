/*
 * eigen_leg.h -- a stretch of a stable manifold, outward in the arc length of
 * one set of coordinates u, z = map u: of W first, of z where W fails.
 */
#ifndef RACE_EIGEN_LEG_H
#define RACE_EIGEN_LEG_H

#include "eigen_drift.h"
#include "eigen_start.h"
#include "flow.h"

/* Its flow's state: u[0], u[1], then the integrals.  Must not move. */
struct eigen_leg {
    const struct eigen_frame *frame; /* borrowed */
    struct mat2 map;
    bool in_W;   /* map is a multiple of the basis; else of 1 */
    double rtol; /* of steps */
    struct ode ode;
    struct event edge; /* of the domain: stops the flow */
    struct flow flow;  /* owned */
    struct eigen_drift drift;
};

/* From the end of a start, in W over its reach.  Errors as flow_init. */
MUST_CHECK enum status eigen_leg_begin(struct eigen_leg *l,
                                       const struct eigen_frame *g,
                                       const struct eigen_start *t, double rtol,
                                       size_t max_steps);

/* On from the end of another leg, in z over its distance from the saddle. */
MUST_CHECK enum status eigen_leg_turn(struct eigen_leg *l,
                                      const struct eigen_leg *from);

/* One step; errors as flow_step.  The drift grows by what its estimates, and
 * its defect between the stages, allow for. */
MUST_CHECK enum status eigen_leg_step(struct eigen_leg *l);

/* z at the end. */
struct vec2 eigen_leg_end(const struct eigen_leg *l);

/* How many times smaller z is there than what it is the difference of, at
 * least 1: digits of u that are lost on z. */
double eigen_leg_cancellation(const struct eigen_leg *l);

/* A second call is harmless. */
void eigen_leg_free(struct eigen_leg *l);

#endif
