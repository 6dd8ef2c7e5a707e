/*
 * control.h -- the step size of a one-step method from its error estimate:
 * PI control, Hairer & Wanner, Solving ODEs II (1996), sec. IV.2, (2.43a).
 */
#pragma once

#include <stdbool.h>

struct control {
    double order;    /* the error estimate goes as h^order */
    double previous; /* the last accepted error */
    bool rejected;   /* the last attempt was */
};

#define CONTROL_INIT(order_) ((struct control){ (order_), 1.0, false })

/* `error`: estimate over tolerance.  True: the step is accepted.  NaN is not.
 * *factor: what to multiply the step by for the next attempt. */
bool control_judge(struct control *c, double error, double *factor);
