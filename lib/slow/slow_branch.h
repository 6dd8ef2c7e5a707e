/*
 * slow_branch.h -- one orbit along a slow curve (slow_curve.h), as a table of
 * the slip and time that are still to come.
 */
#pragma once

#include <stdint.h>

#include "fate.h"
#include "orbit.h"
#include "saddle_series.h"
#include "slow_knot.h"

enum slow_start {
    SLOW_SADDLE,  /* on the curve, beside the saddle */
    SLOW_RUNAWAY, /* the same where no node is ahead and v grows: followed some
                     way, and time and slip are to its end */
    SLOW_BESIDE,  /* elsewhere: it lands first */
    SLOW_FACE     /* on the curve, at a node's box of arrest: its inside, where
                     what is still to come is negative */
};

/* In order of time, so that y rises or falls.  Its fate is that of its end, a
 * node's box of arrest or rest, with -HUGE_VAL for x_end.  Of a rest that takes
 * for ever time is counted to the last knot, and slip, too, where it has no
 * limit (rest_form.h). */
struct slow_branch {
    struct slow_knot *knot; /* owned */
    size_t count, room;
    uint32_t *bin; /* owned: the last knot before each of even parts */
    enum slow_start start;
    int8_t fate;
    double x_end, x_end_error;
    struct vec2 end_aside; /* off its end, per unit off along the fibre there */
    const struct saddle_series *near; /* borrowed: of the saddle that the first
                                         knot is beside; NULL: none */
    struct saddle_point first;        /* of the first knot */
    /* the node that the last knot of SLOW_FACE is beside, the eigenvalue along
     * the curve and the slip rate there: the caller's */
    double centre, grows, v_node;
};

/* The orbit from the offset z, which may end elsewhere than at a node only from
 * the saddle, whose series is `near`: then z lies on its curve.  b->fate is
 * FATE_UNDECIDED where it does not end at all. STATUS_NO_MEMORY,
 * STATUS_STOPPED; *b is to be freed in any case. */
MUST_CHECK enum status slow_branch_run(const struct slider *s, struct vec2 z,
                                       enum slow_start start,
                                       const struct saddle_series *near,
                                       const struct monitor *monitor,
                                       struct slow_branch *b);

/* Whether the rates at the offset z are apart, and x (fast = 0) or y settles
 * first. */
bool slow_branch_may_start(const struct slider *s, int fast, struct vec2 z);

/* The interval of knots that holds y: its later end; 0: none. */
size_t slow_branch_interval(const struct slow_branch *b, double y);

/* A second call is harmless. */
void slow_branch_free(struct slow_branch *b);
