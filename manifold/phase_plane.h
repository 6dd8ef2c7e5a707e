/*
 * phase_plane.h -- a planar system with the steady states of its steady curve:
 * what the slider's geometry and orbits start from.  (Systems of formulas may
 * have any number of equilibria: study/plane_study.h.)
 *
 * The system is anchored at a saddle if there is one, so that offsets
 * (planar.h) are small where digits matter.
 */
#pragma once

#include "equilibrium.h"

/* Among EQUILIBRIA_MAX along one steady curve: they alternate with nodes. */
enum { SADDLES_MAX = 2 };

struct phase_plane {
    struct planar system;
    struct equilibrium equilibrium[EQUILIBRIA_MAX]; /* ascending in x */
    size_t equilibria;
    size_t saddle[SADDLES_MAX], saddles; /* indices */
    double fastest_rate; /* the larger |Re lambda| at the origin, per unit of
                            time */
};

/* Of a system, of which a copy is kept (its ctx must outlive the plane), and
 * its n <= EQUILIBRIA_MAX steady states, ascending in x.  The caller has put
 * the origin on the saddle if there is one. */
struct phase_plane phase_plane_of(const struct planar *system,
                                  const struct equilibrium e[], size_t n);

/* The first saddle; NULL: there is none. */
const struct equilibrium *phase_plane_saddle(const struct phase_plane *p);

/* The rate at which orbits leave the first saddle; 0: there is none. */
double phase_plane_leaving_rate(const struct phase_plane *p);

/* Where steady state i is, as an offset. */
struct vec2 phase_plane_offset(const struct phase_plane *p, size_t i);

/* The offsets of all steady states but the saddles, to which orbits can arrive
 * forward or backward in time; their number. */
size_t phase_plane_goals(const struct phase_plane *p,
                         struct vec2 goal[EQUILIBRIA_MAX]);
