/*
 * arrival.h -- whereto a curve of a plane goes: into an equilibrium's trap, to
 * a saddle that it cannot be told from, on to a closed orbit.
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

enum { WINDING_KEPT = 16, WINDING_MOST = 4 };

/* Returns of a curve to where it is highest, from a start that it does not come
 * back to: where the last `turns` of them repeat the ones before up to `gap`,
 * and these differences have shrunk and go on to, a closed orbit runs within
 * some gaps of them. */
struct winding {
    struct vec2 at[WINDING_KEPT]; /* absolute, the last one first */
    size_t count;                 /* of all */
    double noise;         /* what a piece is off, of 1 + |offset|; given */
    bool begun, up;       /* up: as the field says at the end */
    struct vec2 start;    /* of the curve; of the first, if others go on */
    double near, away;    /* how near to it this round has come, the last one */
    double extent, round; /* how far the curve has been from the last return,
                             and was between the last two */
    double more, off;     /* what pieces are off since the last return, and
                             between the last two */
    size_t turns;         /* returns in one round, once it is closed */
    double gap;
};

/* One more piece of a curve of offsets; true once it winds on to a closed orbit
 * that is far from all n equilibria, in terms of the gap. */
bool winding_add(struct winding *w, const struct planar *sys,
                 const struct arrival_scale *s, const struct curve *c,
                 size_t piece, const struct vec2 equilibrium[], size_t n);

/* Whether it comes back to its start, and twice to where it was up to what
 * the round is off: it is one of many closed orbits, as far as numbers tell. */
bool winding_is_closed(const struct winding *w, const struct arrival_scale *s);
