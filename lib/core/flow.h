/*
 * flow.h -- adaptive integration of a small system u' = rhs(s, u) by the
 * explicit method of order 8, every step a polynomial piece of a curve.
 */
#pragma once

#include "control.h"
#include "event.h"
#include "explicit8.h"
#include "status.h"

struct flow_options {
    double rtol;                /* > 0 */
    double atol[CURVE_DIM_MAX]; /* >= 0; error weight: atol_i + rtol |u_i| */
    double first_step;          /* > 0; 0: found out */
    size_t max_steps;           /* accepted and rejected */
    const struct event *event;  /* borrowed */
    size_t events;              /* <= EVENT_COUNT_MAX */
};

enum flow_end {
    FLOW_RUNNING,
    FLOW_REACHED, /* s_end */
    FLOW_EVENT,   /* a stop event, number end_index */
};

/* The state (s, u) is the end of the curve.  The curve's components are those
 * of u; s is linear in theta on each piece and not stored: whoever needs it
 * adds a component with derivative 1. */
struct flow {
    const struct ode *ode; /* borrowed */
    struct flow_options options;
    struct curve curve;   /* owned */
    struct event_log log; /* owned */
    double s, u[CURVE_DIM_MAX];
    enum flow_end end;
    size_t end_index;
    size_t steps, rejected, calls;
    double error[CURVE_DIM_MAX]; /* sum of the steps' error estimates */
    double h;                    /* size of the next step */
    struct control control;
    struct explicit8 work;
};

/* Starts at (s, u).  STATUS_BAD_ARGUMENT: an option outside its range;
 * STATUS_NO_CONVERGENCE: the derivative there is not finite.  Nothing to free
 * in either case, though flow_free is harmless. */
MUST_CHECK enum status flow_init(struct flow *f, const struct ode *ode,
                                 double s, const double u[],
                                 const struct flow_options *options);

/* One accepted step towards s_end (on either side of s), appended to the
 * curve, its events to the log.  Sets f->end when it was the last; then does
 * nothing.  STATUS_NO_CONVERGENCE: no step however short is accepted, e.g.
 * where rhs gives NaN; STATUS_TOO_MANY_STEPS; STATUS_NO_MEMORY.  After an
 * error the curve up to (f->s, f->u) is valid. */
MUST_CHECK enum status flow_step(struct flow *f, double s_end);

/* A second call is harmless. */
void flow_free(struct flow *f);
