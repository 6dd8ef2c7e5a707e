/*
 * taylor_orbit.h -- one orbit of a planar system forward in time, by Taylor
 * series in time: a dozen steps a turn where nothing is stiff.
 */
#pragma once

#include "curve.h"
#include "planar.h"

struct taylor_orbit {
    const struct planar *system; /* borrowed; with jets */
    struct vec2 side;            /* lengths are in units of these */
    double rtol;  /* allowed of each step, of 1 + |offset| in these units */
    size_t order; /* of the series, in 4..JET_SIZE - 1 */
    struct curve curve; /* owned; of dim 2, pieces of that degree, without
                           bars */
    struct vec2 z;      /* its end */
    double bent;        /* how much its velocity changed on the last step, of
                           itself, by its derivative at the start: little in
                           step after step where the field is stiff */
    bool blurred; /* shorter steps were no truer: rounding held the last back */
};

/* Starts at the offset z. */
struct taylor_orbit taylor_orbit_at(const struct planar *system, struct vec2 z,
                                    struct vec2 side, double rtol);

/* One more piece.  STATUS_NO_CONVERGENCE: no series however short is the
 * field's, or nothing moves; STATUS_NO_MEMORY. */
MUST_CHECK enum status taylor_orbit_step(struct taylor_orbit *o);

/* A second call is harmless. */
void taylor_orbit_free(struct taylor_orbit *o);
