/*
 * workprec_orbit.h -- a forward orbit of the block in 113 bits, stiff as it is:
 * the end states and slips that races are judged by.  By a method, and a
 * program, that shares nothing with orbit.h but the formulas of the field.
 */
#ifndef RACE_WORKPREC_ORBIT_H
#define RACE_WORKPREC_ORBIT_H

#include "quad_block.h"

/* Where to stop: at `time`, or, if it is 0, within `arrival` of one of the
 * targets in both coordinates. */
struct workprec_goal {
    quad time;
    quad (*target)[2]; /* offsets from the anchor; borrowed */
    size_t targets;
    double arrival;
};

struct workprec_state {
    quad z[2]; /* offset from the anchor */
    quad time, slip;
    size_t steps;
};

/* From the offset z; tol: of what a step leaves out, in ln v, ln psi and of
 * slip: 1e-18 is far below every double.  False where no step is short enough,
 * or none leads to the goal. */
bool workprec_orbit_run(const struct law *law, const struct quad_anchor *at,
                        const quad z[2], const struct workprec_goal *goal,
                        double tol, struct workprec_state *out);

#endif
