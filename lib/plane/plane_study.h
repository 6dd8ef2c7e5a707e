/*
 * plane_study.h -- give it a scene with a system of formulas, and it returns
 * the equilibria, the manifolds of all saddles, the portrait and the basins
 * that the scene asks for.
 *
 * Points are absolute in the chart, where positive states are logarithms;
 * curves are offsets from their origin.
 */
#pragma once

#include "arrival.h"
#include "branch.h"
#include "equilibria.h"
#include "portrait.h"
#include "proof_trap.h"
#include "proof_tube.h"
#include "record.h"
#include "region.h"
#include "scene.h"
#include "system_plane.h"
#include "winding.h"

/* Types of equilibria, in this order; NULL-ended. */
enum plane_type {
    PLANE_SADDLE,
    PLANE_STABLE_NODE,
    PLANE_STABLE_FOCUS,
    PLANE_UNSTABLE_NODE,
    PLANE_UNSTABLE_FOCUS,
    PLANE_NONHYPERBOLIC,
    PLANE_TYPES
};
extern const char *const plane_type_names[];

enum { PLANE_NAME = 24 };

/* A closed curve about an equilibrium, which orbits only cross inward:
 * plane_turn.h.  In offsets from it, in sides of the window. */
struct plane_turn {
    struct vec2 *at;      /* owned: corners */
    size_t corners, room; /* corners 0: none */
    double off;           /* from straight between corners, at most */
    struct box box;       /* around the corners */
};

struct plane_rest {
    char word[2 * PLANE_NAME + 48];
    const char *name;     /* word: its type and its number among these; outside
                             the window where it is, as of struct plane_beyond */
    int8_t type;          /* enum plane_type */
    struct vec2 z, error; /* bounds of each coordinate */
    struct box alone;     /* there is no other within */
    struct system_equilibrium exact; /* to all digits that are known */
    struct quantity state[2];
    struct plane_lambda {
        struct quantity re, im;
    } lambda[2]; /* ascending; or a pair, im < 0 first */
    struct tape_plane
        *plane; /* owned: about it, forward and backward in time */
    struct planar system[2];
    struct trap_form trap[2];
    struct plane_turn turn[2];
    struct quantity share; /* of the window; with basins */
};

/* Where a curve ends, in this order; NULL-ended. */
enum plane_end {
    PLANE_END_EQUILIBRIUM,
    PLANE_END_CYCLE,
    PLANE_END_SADDLE,
    PLANE_END_INFINITY,    /* it has left TOL_PLANE_FAR windows */
    PLANE_END_EDGE,        /* outside the window as far as it was followed */
    PLANE_END_SINGULARITY, /* formulas have no values there */
    PLANE_END_STEPS,       /* in the window, as far as steps go */
    PLANE_END_UNKNOWN      /* as codes go, -1 */
};
extern const char *const plane_end_names[];

struct plane_branch {
    int64_t saddle;         /* number among the saddles */
    size_t rest;            /* that saddle's number among all */
    int8_t kind;            /* enum manifold_kind */
    int64_t branch;         /* 0: where x grows first (y, if vertical), 1 */
    struct branch curve;    /* owned; offsets from its saddle */
    int8_t end;             /* enum plane_end, or -1 */
    int64_t to;             /* number of the equilibrium or cycle; or none */
    struct quantity length; /* in the chart, from the saddle to the end, or to
                               where it last leaves the window */
    struct quantity leaves[2]; /* the state where it leaves the window for
                                  good; plane_numbers.h */
    int8_t edge; /* by which: 0, 1 the first state's ends, 2, 3 the second's */
    int8_t end_proved;      /* enum plane_proved, where it was asked for */
    const char *not_proved; /* why its end is not; static, or NULL */
    size_t shown;           /* pieces up to that place */
    double shown_to;        /* theta there, on the last of them */
};

struct plane_cycle {
    char word[PLANE_NAME];
    const char *name;     /* word */
    int8_t type;          /* of plane_cycle_types */
    struct winding round; /* its last returns are on it */
};

enum plane_cycle_type { PLANE_CYCLE_STABLE, PLANE_CYCLE_UNSTABLE };
extern const char *const plane_cycle_types[];

/* What orbits go to that is not in the window: infinity of the chart, an
 * equilibrium outside, or where formulas have no values.  Each coordinate
 * grows, falls, has a limit, or does what is not known; the word tells what is
 * known, "x_to_0_y_to_1", or else "infinity", "outside" or "singularity". */
struct plane_beyond {
    bool rests;  /* an equilibrium */
    bool breaks; /* no: where the formulas have no values */
    enum plane_way {
        PLANE_WAY_UNKNOWN,
        PLANE_WAY_LIMIT,
        PLANE_WAY_UP,
        PLANE_WAY_DOWN
    } way[2];
    double limit[2]; /* in the chart */
    char word[2 * PLANE_NAME + 48];
};

/* Why that is not known of an orbit, or was not asked. */
enum plane_unknown {
    PLANE_UNKNOWN_CLOSED,
    PLANE_UNKNOWN_LOST,
    PLANE_UNKNOWN_STEPS,
    PLANE_UNKNOWN_WORK,
    PLANE_UNKNOWN_CELLS,
    PLANE_UNKNOWN_BORDER,
    PLANE_UNKNOWNS
};
extern const char *const plane_unknown_texts[PLANE_UNKNOWNS];

/* Whereto an orbit goes. */
struct plane_goal {
    enum plane_goal_kind {
        PLANE_GOAL_NONE, /* as far as it was followed */
        PLANE_GOAL_LEFT, /* outside the window for good: escape.h */
        PLANE_GOAL_REST,
        PLANE_GOAL_CYCLE,
        PLANE_GOAL_BEYOND
    } kind;
    enum plane_unknown why; /* of none */
    size_t index;         /* of the rest, of the cycle; cycles: one not known */
    struct winding round; /* of a cycle */
    struct plane_beyond beyond;
    size_t steps; /* that it took to know */
};

/* Rounds of an orbit about the window, which it has left for good
 * (manifold/escape.h), by where they cross the ray: orbits that cross it
 * between two of them go where it went.  count 0: none is known. */
enum { PLANE_ROUNDS = 512 };

struct plane_rounds {
    double at[PLANE_ROUNDS], sense;
    size_t count;
    struct plane_goal goal;
};

/* A share of the window, by area as it is drawn. */
struct plane_share {
    const char *attractor; /* borrowed; an equilibrium, a cycle, what is
                              beyond the window, "undecided" */
    struct quantity fraction;
};

/* A curve between basins, about the study's origin: a stable manifold, or a
 * cycle that repels. */
struct plane_border {
    struct branch half[2]; /* owned */
    size_t of; /* the first of its two branches; or s->branches + the cycle */
    int way;   /* of a manifold: 1 where half[1] is of the second of the two */
    size_t first, last; /* its strands */
    bool divides;       /* different labels lie on its sides in the window */
};

/* One that divides the window: its manifold, or none, and whose it is. */
struct plane_boundary {
    int64_t manifold;
    const char *of; /* borrowed */
};

/* The cells of a region within which orbits go to different attractors:
 * plane_mosaic.h. */
struct plane_mosaic {
    size_t region;
    int n;         /* cells a side */
    int8_t *label; /* owned; n x n, by rows; -1: not known */
};

/* Shares that are no equilibrium's. */
struct plane_elsewhere {
    struct quantity infinity, outside, singularity, cycles, undecided;
};

struct plane_basin {
    struct plane_border *border; /* owned */
    size_t borders, border_room;
    struct separatrix cuts;    /* of all of them; along y */
    struct separatrix columns; /* the same along x */
    struct regions regions;
    double shut; /* part of the window that may be on either side of a door
                    (plane_patch.c) that is shut */
    struct plane_mosaic *mosaic; /* owned */
    size_t mosaics, mosaic_room;
    struct plane_goal *goal; /* owned: of the cells of mosaics */
    size_t goals, goal_room;
    struct plane_share *share;       /* owned; by label */
    const char **name;               /* owned; their names, NULL-ended */
    size_t labels, shares;           /* shares: and "undecided" */
    struct plane_boundary *boundary; /* owned */
    size_t boundaries;
    int64_t cells, disagreements; /* of the audit */
    int64_t neutral; /* closed orbits met, not told to attract others */
    bool unknown[PLANE_UNKNOWNS]; /* reasons met for what is undecided */
    int64_t steps; /* of all orbits: TOL_PLANE_WORK ends labels and audit */
    struct plane_elsewhere elsewhere;
};

/* What proves the end of a branch: its tube, and where it comes in. */
struct plane_tube {
    struct proof_branch tube; /* pieces and cells owned */
    struct proof_trap trap;
    double turns[2]; /* of angles, from the equilibrium to the trap */
};

/* Derivatives of an equilibrium's numbers: its state, re and im of both
 * eigenvalues. */
enum { PLANE_SLOPES = 6 };
struct plane_slope {
    struct quantity by[PLANE_SLOPES];
};

struct plane_count {
    int64_t equilibria, undecided, saddles, cycles, attractors;
};

struct plane_box {
    double range[2][2]; /* of each state */
};

struct plane_study {
    const struct scene *scene; /* borrowed */
    unsigned products;
    struct system_lowered *lowered; /* owned */
    struct interval_plan *plan;     /* owned; plane_defined.h */
    bool entire;                    /* formulas have values everywhere */
    bool broken; /* formulas may have no values somewhere in the window */
    struct tape_plane *plane; /* owned: about a place of the window */
    struct planar system[2];  /* forward and backward in time */
    struct window window;
    struct planar_observable observable[PLANAR_OBSERVABLES_MAX];
    struct arrival_scale scale;
    double kappa; /* orbit.h */

    struct plane_rest *rest;     /* owned; those in the window, ascending in x,
                                    then y; others that its basins need */
    size_t rests, listed;        /* listed: in the window */
    size_t saddles;              /* in the window */
    bool complete;               /* the window was proved to hold no others */
    struct plane_box *undecided; /* owned; where others may be */
    size_t undecided_count;

    struct plane_branch *branch; /* owned; 4 a saddle: stable, unstable; of one
                                    outside the window the stable ones */
    size_t branches, listed_branches; /* listed: of saddles in the window */
    struct plane_cycle *cycle;        /* owned */
    size_t cycles;
    struct plane_beyond *beyond; /* owned; no two agree, "infinity" and
                                    "outside" are last; with the basins */
    size_t beyonds;
    struct plane_rounds rounds;
    struct portrait portrait;     /* owned; trajectories: forward */
    struct trajectories backward; /* owned; from the same starts */
    struct plane_basin basin;     /* members owned */
    struct plane_count count;
    struct plane_proof {
        struct proved (*of)[2]; /* owned; numbers point into it */
        size_t count;
        struct plane_tube *tube; /* owned; of the listed branches */
        size_t tubes;
        struct fault lie; /* which number contradicts its bar; empty: none */
    } proof;
    struct plane_slope *slope; /* owned; by equilibrium, then by parameter */
    struct plane_table *table; /* owned; plane_results.h */
};

/* The products run; the scene's, or these where it names none.  Errors as
 * study_run, STATUS_BAD_SCENE also where a formula cannot be run; on error *s
 * is empty.  s must not move. */
MUST_CHECK enum status plane_study_run(struct plane_study *s,
                                       const struct scene *scene,
                                       const struct monitor *monitor,
                                       struct fault *why);

/* A second call is harmless. */
void plane_study_free(struct plane_study *s);

/* The planar systems about a place of the chart, forward and backward in time,
 * which borrow plane[].  STATUS_BAD_SCENE: no formulas have values there. */
MUST_CHECK enum status plane_study_about(
    const struct plane_study *s, bool equilibrium, const formula_real at[2],
    struct tape_plane plane[2], struct planar system[2], struct fault *why);

/* How fast a state moves at an absolute point, in sides of the window. */
double plane_study_speed(const struct plane_study *s, struct vec2 z);

/* The window; an angle is in it wherever it is. */
struct box plane_study_box(const struct plane_study *s);

/* A coordinate of the chart as the state that it is, and the way back. */
double plane_state(const struct plane_study *s, int axis, double z);
double plane_chart(const struct plane_study *s, int axis, double state);
