/*
 * arrival.h -- whereto a curve of a plane goes: into an equilibrium's trap, or
 * to a saddle that it cannot be told from.
 *
 * Distances are in units of `side`, the sides of a window; where a coordinate
 * has a period, up to that.
 */
#pragma once

#include "curve.h"
#include "equilibrium.h"

/* How lengths are taken. */
struct arrival_scale {
    struct vec2 side, period; /* period 0: none */
};

/* From b to a, in units of the sides, each coordinate by the shortest way. */
struct vec2 arrival_from(const struct arrival_scale *s, struct vec2 a,
                         struct vec2 b);

/* How near a piece of a curve of offsets from an origin comes to an absolute
 * point, and where; HUGE_VAL, soon, where that is certainly more than `most`.
 */
double arrival_nearest(const struct arrival_scale *s, const struct curve *c,
                       size_t piece, struct vec2 origin, struct vec2 to,
                       double most, double *theta);

/* V(u) = u'Pu <= size^2, u = arrival_from(z): V falls along every orbit there,
 * half as fast at least as along those of the linear part, looked at on
 * ellipses; V >= u'u.  size 0: none. */
struct trap_form {
    struct vec2 z; /* absolute */
    double pxx, pxy, pyy, size;
};

/* Of the equilibrium at the origin of a system; that of the reversed one traps
 * orbits backward in time. */
struct trap_form trap_form_at(const struct planar *sys,
                              const struct arrival_scale *s);

/* sqrt V at an absolute point. */
double trap_form_distance(const struct trap_form *t,
                          const struct arrival_scale *s, struct vec2 z);
