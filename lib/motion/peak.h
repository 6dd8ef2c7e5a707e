/*
 * peak.h -- the largest slip rate and the largest friction along an orbit.
 */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "plane.h"
#include "status.h"

struct slider;

struct peaks {
    double x;   /* ln v */
    double mu;  /* dimensionless */
    bool whole; /* of a block that fades: it was followed until no more friction
                   is to come */
    double x_error, mu_error;
};

/* Along the orbit that fate_find(s, z, rtol, true, ...) follows in `steps`
 * steps (its result says how many), both ends included, and after its end if it
 * fades; the errors bound what that orbit and rounding leave.  Of several
 * maxima between neighbouring samples (TOL_EVENT_SAMPLES a step) all but one
 * may be missed.  Errors as fate_find; *out untouched. */
MUST_CHECK enum status peaks_find(const struct slider *s, struct vec2 z,
                                  double rtol, size_t steps, struct peaks *out);
