/*
 * system_plane.h -- a system of formulas (system.h) as planar systems about
 * any points of its chart, forward and backward in time.
 *
 *     system_plane_lower(&l, s, why);                     once
 *     system_plane_at(&l, true, false, anchor, &t, why);  about an equilibrium
 *     struct planar p = tape_planar(&t);
 */
#pragma once

#include "system.h"
#include "tape_plane.h"

/* By [equilibrium][backward]; with its parameters' numbers.  Very large. */
struct system_lowered {
    struct tape_lowered way[2][2];
    struct formula_value value[SYSTEM_PARAMETERS + 1];
    char name[SYSTEM_PARAMETERS][FORMULA_NAME];
};

/* Of a system with its parameters' values now; it is copied.  STATUS_BAD_SCENE
 * with one line in *why. */
MUST_CHECK enum status system_plane_lower(struct system_lowered *out,
                                          const struct formula_system *s,
                                          struct fault *why);

/* anchor: in the chart, to all digits that are known; with `equilibrium`, rates
 * vanish there whatever rounding makes of them.  STATUS_BAD_SCENE where a
 * formula has no finite value there. */
MUST_CHECK enum status system_plane_at(const struct system_lowered *l,
                                       bool equilibrium, bool backward,
                                       const formula_real anchor[2],
                                       struct tape_plane *out,
                                       struct fault *why);
