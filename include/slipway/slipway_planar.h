/*
 * slipway_planar.h -- an analytic system of one's own, typed as formulas, in a
 * window of the plane: its equilibria, the invariant manifolds of its saddles,
 * its closed orbits, and whereto every state goes.
 *
 *     slipway_plane *plane = NULL;
 *     slipway_number kick[2];
 *     slipway_fault why;
 *     const char *goal;
 *     if (slipway_plane_open("x' = y; y' = x - x^3 - d*y; d = 0.1",
 *                            "{x: [-2, 2], y: [-2, 2]}", &plane, &why))
 *         ... why.text is one line, with the column of a wrong formula ...
 *     slipway_plane_goal(plane, 1.0, 1.0, &goal, kick);   "stable_focus_0"
 *     slipway_plane_free(plane);
 *
 * States are numbers as the formulas have them, in the order in which their
 * rates are given.  A plane may be read by many threads at once.
 */
#ifndef SLIPWAY_SLIPWAY_PLANAR_H
#define SLIPWAY_SLIPWAY_PLANAR_H

#include "slipway.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct slipway_plane slipway_plane;

/* The system of equations "x' = ...; y' = ..." with its parameters and named
 * expressions, over a window as scenes write it.  BAD_SCENE: a formula that
 * cannot be read or an empty window, with the reason; NO_MEMORY. */
slipway_status slipway_plane_open(const char *equations, const char *window,
                                  slipway_plane **out, slipway_fault *why);

/* The same of a scene with a `system`, which has positive states, angles, and
 * everything else; basins.audit = 0 spares the audit of its basins.
 * BAD_SCENE also where it has none; STOPPED by the monitor, which may be NULL.
 * The scene is not kept. */
slipway_status slipway_plane_run(const slipway_scene *scene,
                                 const slipway_monitor *monitor,
                                 slipway_plane **out, slipway_fault *why);

/* Of its first (0) and its second state (1). */
slipway_axis slipway_plane_axis(const slipway_plane *plane, int axis);

/* What each function below lists: the number of all; the first `room` of them
 * into out[].  Names are valid as long as the plane. */

typedef enum slipway_rest_type {
    SLIPWAY_REST_SADDLE,
    SLIPWAY_REST_STABLE_NODE,
    SLIPWAY_REST_STABLE_FOCUS,
    SLIPWAY_REST_UNSTABLE_NODE,
    SLIPWAY_REST_UNSTABLE_FOCUS,
    SLIPWAY_REST_NONHYPERBOLIC
} slipway_rest_type;

typedef struct slipway_rest {
    const char *name; /* its type and its number among these: "saddle_0" */
    slipway_rest_type type;
    slipway_number state[2];
    slipway_number re[2], im[2]; /* eigenvalues, in rising order */
    slipway_number share;        /* of the window that goes there */
} slipway_rest;

/* Ascending in the first state, then in the second.  *complete (may be NULL):
 * the window was proved to hold no others. */
size_t slipway_plane_equilibria(const slipway_plane *plane, slipway_rest out[],
                                size_t room, int *complete);

typedef enum slipway_kind { SLIPWAY_STABLE, SLIPWAY_UNSTABLE } slipway_kind;

typedef struct slipway_manifold {
    size_t saddle; /* number of its equilibrium */
    slipway_kind kind;
    int branch; /* 0: where the first state grows at the saddle (the second,
                   if that stands still); 1: the other one */
    const char *end; /* "equilibrium", "cycle", "saddle", "infinity", "edge";
                        NULL: not known */
    long to;         /* number of that equilibrium or closed orbit; -1 */
    slipway_number length; /* logarithms of positive states */
} slipway_manifold;

/* Four a saddle. */
size_t slipway_plane_manifolds(const slipway_plane *plane,
                               slipway_manifold out[], size_t room);

/* In the chart, where positive states are logarithms: length from the saddle,
 * slope dy/dx, a bound on the distance to the exact curve. */
typedef struct slipway_place {
    double arc, state[2], slope, error;
} slipway_place;

/* Points of manifold number `which`, from the saddle to where it leaves the
 * window for good, lent for as long as the plane is there; NULL and 0: there is
 * no such manifold. */
const slipway_place *slipway_plane_points(const slipway_plane *plane,
                                          size_t which, size_t *count);

typedef struct slipway_share {
    const char *attractor; /* an equilibrium, a closed orbit, what is beyond the
                              window, or "undecided" */
    slipway_number fraction; /* of the window's area */
} slipway_share;

size_t slipway_plane_shares(const slipway_plane *plane, slipway_share out[],
                            size_t room);

/* Whereto a state goes, as a name of the shares, and the smallest change of
 * each state alone, inside the window, after which it goes elsewhere: what is
 * added, or of a positive state the factor; kick may be NULL.  BAD_ARGUMENT:
 * not a state; NO_MEMORY. */
slipway_status slipway_plane_goal(const slipway_plane *plane, double x,
                                  double y, const char **attractor,
                                  slipway_number kick[2]);

void slipway_plane_free(slipway_plane *plane);

#ifdef __cplusplus
}
#endif

#endif
