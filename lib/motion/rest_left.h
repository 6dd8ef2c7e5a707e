/*
 * rest_left.h -- the time and the slip that are left to a block which comes to
 * rest: integrals along the curve that its orbit has fallen onto.
 *
 * Where friction balances the slope but for inertia, that is v = v_s(psi),
 *
 *     T = int_psi^inf dpsi/(dpsi/dt),     X = int_psi^inf v_s dpsi/(dpsi/dt),
 *
 * with mu(v_s, psi) - tan(alpha) = -eps^2/cos(alpha) dv_s/dt (quasistatic.h),
 * and where only inertia slows it (rest_lag.h) the same over ln v, from there
 * to -inf.  Both go on beyond what doubles hold of v and psi.
 */
#pragma once

#include <stdbool.h>

#include "plane.h"

struct slider;

/* In units of L/V_star and L, with absolute bounds of their errors; HUGE_VAL
 * with a bar of 0 where there is no limit (rest_form.h). */
struct rest_left {
    double time, slip;
    double time_error, slip_error;
    double time_slope, slip_slope; /* what an error of 1 in ln v, or in psi's
                                      coordinate, would make of them; > 0 */
};

/* From the offset z on.  False where the block is not on its way to rest, not
 * on that curve, or v is not so small that the bars are, too, beside all of it
 * with the `time` until now. */
bool rest_left_find(const struct slider *s, struct vec2 z, double time,
                    struct rest_left *out);

/* The gradient of the coordinate that both are functions of. */
struct vec2 rest_left_section(const struct slider *s);

/* What goes by where only inertia slows it, while ln v falls by h from the
 * offset x. */
struct rest_left rest_left_between(const struct slider *s, double x, double h);
