/*
 * equilibria.h -- every equilibrium of a planar system in a window, each proved
 * to be there and to be the only one in its box, and the proof that there is no
 * other; or the boxes where neither was possible.
 *
 *     struct system_equilibria *found = ...;
 *     system_equilibria_find(&s, &window, found, &why);
 *     found->complete, found->equilibrium[i].state[0].value, ...
 *
 * Everything is enclosed in intervals that are rounded outward (interval.h):
 * what is said to be proved is, for the decimals as typed.  The work is
 * bounded: a whole curve of equilibria ends within a second or so as boxes.
 */
#pragma once

#include "system.h"

enum { SYSTEM_EQUILIBRIA = 500, SYSTEM_UNDECIDED = 100 };

/* By the real parts of the eigenvalues and whether they are real; nonhyperbolic
 * where the bar of a real part holds 0. */
enum system_equilibrium_type {
    SYSTEM_SADDLE,
    SYSTEM_STABLE_NODE,
    SYSTEM_STABLE_FOCUS,
    SYSTEM_UNSTABLE_NODE,
    SYSTEM_UNSTABLE_FOCUS,
    SYSTEM_NONHYPERBOLIC,
    SYSTEM_EQUILIBRIUM_TYPES
};

/* What it is lies within error of value. */
struct system_number {
    formula_real value;
    double error;
};

struct system_equilibrium {
    enum system_equilibrium_type type;
    struct system_number chart[2]; /* on the axes: the state or its logarithm */
    struct system_number state[2];
    /* per unit of t: real ones in rising order, or im < 0 first */
    struct {
        struct system_number re, im;
    } eigenvalue[2];
    double box[2][2]; /* of each axis, lo and hi: there is no other within */
};

/* A part of the plane, in the chart; an angle is searched once round, from lo,
 * whatever hi is. */
struct system_window {
    double lo[2], hi[2];
};

struct system_equilibria {
    struct system_equilibrium equilibrium[SYSTEM_EQUILIBRIA];
    int count; /* in the order of the first axis, then of the second */
    struct system_window undecided[SYSTEM_UNDECIDED];
    int undecided_count;
    bool complete; /* nothing is undecided: there are no others */
    long boxes;    /* that were looked at */
};

/* Which of its edges belong to the window does not matter: an equilibrium whose
 * bar touches it is in it.  STATUS_BAD_ARGUMENT: a window that is none, a
 * function without a rule; STATUS_NO_MEMORY. */
MUST_CHECK enum status system_equilibria_find(
    const struct formula_system *s, const struct system_window *window,
    struct system_equilibria *out, struct fault *why);
