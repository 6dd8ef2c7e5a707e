/*
 * cusp.h -- where the two extrema of mu_ss meet as c grows (Putelat & Dawes
 * 2015, Fig 4).
 *
 * With psi_ss = top/(r + v), r = 1/R, and c' beside psi in theta, extrema lie
 * where c' = top ((b - a) v - a r)/(a (r + v)^2): explicit in v, largest at
 *
 *     v* = (a + b)/((b - a) R),   c'* = top R (b - a)^2/(4 a b),
 *
 * which is c* = (1 + R)(b - a)^2/(4 a b) for the spinodal presets.
 */
#pragma once

#include "law.h"

struct cusp {
    const char *reason; /* static: why there is none; NULL if there is one */
    long double c, x;   /* x = ln v*; both to some last bits */
};

struct cusp cusp_find(const struct law *law, const struct material *m);
