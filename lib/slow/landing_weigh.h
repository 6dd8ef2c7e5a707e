/*
 * landing_weigh.h -- what the steps of a landing (landing.h) have missed of its
 * time and slip, with their signs, once it is known what comes after them.
 */
#pragma once

#include "landing.h"

/* What a step of order 8 misses of a number, of its largest term of order 6 or
 * 7; size: of the number's terms, apart: of how both of order 6 differ. */
double landing_missed(const double size[LANDING_TERMS], double apart);

/* Of time and slip still to come. */
struct landing_slope {
    double time, slip;
};

/* A bound on what steps and rounding have made of time and slip, and of slip
 * less v time, at the end of the walk, where `across` is what the rest of time
 * and slip changes by per unit to the left of it. */
struct landing_bar {
    double time, slip, more;
};
struct landing_bar landing_weigh(const struct landing *l,
                                 const struct landing_slope *across, double v);
