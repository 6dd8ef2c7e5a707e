/*
 * workprec_task.h -- what every method of a race is asked for, and the truth
 * in 113 bits.
 *
 * Around the saddle of one slope, which all of them are given: the limits of
 * both branches of its stable manifold, the integral along one, the branches
 * themselves within the window, where they cross some rows, where an orbit is
 * at a time, and how far some states slip before they arrive at a node.
 */
#pragma once

#include "quad_orbit.h"
#include "study.h"
#include "workprec_curve.h"

enum workprec_quantity {
    WORKPREC_V_PLUS,
    WORKPREC_V_MINUS,
    WORKPREC_X_EXCESS,
    WORKPREC_CURVE,     /* both branches within the window */
    WORKPREC_TRANSIENT, /* the state of an orbit at a time */
    WORKPREC_ROWS,      /* where both branches cut rows of a map */
    WORKPREC_SLIP,      /* slip of some states to arrest */
    WORKPREC_QUANTITIES
};
extern const char *const workprec_quantity_names[];
/* What is meant and how errors of it are measured, one phrase. */
extern const char *const workprec_quantity_texts[];

enum {
    WORKPREC_SIDES = 2,     /* upper, lower: enum side */
    WORKPREC_ROWS_MOST = 8, /* of each branch */
    WORKPREC_CELLS_MOST = 3,
    WORKPREC_POINTS_MOST = 4096
};

/* Where the rows cut one branch. */
struct workprec_cuts {
    double row[WORKPREC_ROWS_MOST]; /* offsets y, outward */
    quad x[WORKPREC_ROWS_MOST];     /* absolute */
    size_t count;
};

struct workprec_truth {
    struct quad_slope slope; /* at the saddle */
    quad v[WORKPREC_SIDES], x_excess;
    struct quad_branch curve[WORKPREC_SIDES];
    struct workprec_cuts cuts[WORKPREC_SIDES];
    quad state[2]; /* absolute */
    quad slip[WORKPREC_CELLS_MOST];
};

struct workprec_task {
    const struct study *study; /* borrowed; its steady states are known */
    const struct equilibrium *saddle;
    const char *reason[WORKPREC_QUANTITIES]; /* why there is no such thing;
                                                NULL: there is */
    struct box reach;                        /* the window, as offsets */
    struct vec2 start;                       /* of the orbit, offset */
    double until;
    struct vec2 cell[WORKPREC_CELLS_MOST]; /* absolute */
    size_t cells, most;                    /* most: of them, as asked for */
    struct vec2 target[EQUILIBRIA_MAX];    /* nodes, as offsets */
    size_t targets;
    size_t sample; /* points of a curve that are looked at, each branch */
    const struct workprec_plane *plane; /* borrowed; of a system of formulas,
                                           which has no `truth`; or NULL */
    struct workprec_truth truth;
};

/* At most `cells` states and `sample` points of a branch.  A slope without a
 * saddle has none of the quantities.  STATUS_STOPPED. */
MUST_CHECK enum status workprec_task_init(struct workprec_task *c,
                                          const struct study *s, size_t cells,
                                          size_t sample,
                                          const struct monitor *monitor);
