/* close.h -- what is left of a branch that approaches an asymptote. */
#pragma once

#include "local.h"

struct tail {
    double unknown; /* change of the dependent coordinate from z to infinity */
    double unknown_error;
    double integral[LOCAL_CARRY_MAX];
    double integral_error[LOCAL_CARRY_MAX]; /* infinite where it diverges */
    double unknown_by_dep;                  /* how they go with dep at z */
    double integral_by_dep[LOCAL_CARRY_MAX];
};

/* Errors that are more than these make a tail useless; infinite: none does. */
struct tail_most {
    double unknown;
    double integral[LOCAL_CARRY_MAX];
};

/* The dependent coordinate and the carried integrals from z to ind ->
 * toward * infinity, where the slope d dep/d ind decays at least
 * exponentially.  False, with *t undefined, where it does not decay, or where
 * an error is more than `most`, which a part of the work may tell.  at: what
 * was seen at z with the rate of many_carried(carry). */
bool close_tail(const struct planar *sys, int ind, int toward, struct vec2 z,
                const struct planar_look *at, const struct carry *carry,
                const struct tail_most *most, struct tail *t);
