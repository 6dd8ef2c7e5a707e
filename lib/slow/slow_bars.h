/*
 * slow_bars.h -- how far time, slip and x of a slow branch (slow_branch.h) are
 * off at the places of its knots: by the drift of its orbit (drift.h).
 */
#pragma once

#include "slow_branch.h"
#include "slow_off.h"

/* At the end of the orbit's last step, the knot k: how far beside it is, and
 * what time and slip of the step are off; *was: as of slow_off_gained. */
void slow_bars_note(const struct orbit *o, struct slow_knot *k,
                    struct slow_off *was);

/* From each step's to a bound from each knot on, or from the first one to it.
 */
void slow_bars_add(const struct orbit *o, struct slow_branch *b);

/* How far x is off where a function with this gradient has its value. */
double slow_bars_beside(const struct orbit *o, const struct slow_knot *k,
                        struct vec2 gradient);
