/*
 * push.h -- what becomes of single states of a slope, how far they slip and
 * how long that takes, and the smallest kicks that would change it.
 *
 *     struct push p;
 *     push_init(&p, &scene, NULL, &fault);
 *     push_tabulate(&p, NULL);
 *     push_find_all(&p, state, count, NULL, answer);
 *     push_free(&p);
 *
 * The fate is that of the state's side of the saddle's stable manifold
 * (labels.h), which is followed to the ends of the domain, so a state may lie
 * anywhere.
 */
#pragma once

#include "fast_cells.h"
#include "labels.h"
#include "scene.h"
#include "slider.h"

/* A state: slip rate in units of V_star, psi as the law's (law.h). */
struct push_state {
    double v, psi;
};

struct push_answer {
    struct push_state at;
    const char *id; /* borrowed, of whoever asks; NULL: none */
    int8_t fate;    /* enum fate */
    /* To arrest, from the state's own orbit; in units of L and L/V_star.  The
     * bar is that orbit's (fate.h), or fast_cells.h's. */
    struct quantity slip, time, mu_mean;
    /* Factors on v and on psi (a shift of psi where psi is a logarithm) that
     * lead just onto the nearest boundary of another fate; beyond lies it. */
    struct quantity v_kick, psi_kick;
    double arrest; /* where inputs scatter: lib/ensemble/push_scatter.h; NaN:
                      it is not known */
};
/* [0]: from fate on, [1]: with the state before it; [][0]: to the kicks, [][1]:
 * with arrest.  And arrest alone. */
extern const struct record_type record_push[2][2], record_push_arrest;

struct push {
    const struct scene *scene; /* borrowed */
    struct slider slider;
    struct labels labels;   /* owned */
    struct fast_cells fast; /* owned; empty unless tabulated */
};

/* Steady states and the fates of both sides of the separatrix for the
 * scene's law, material and slope.  p must not move.  On error *p is empty and
 * *why says what failed: STATUS_BAD_SCENE (no slope), STATUS_NOT_HYPERBOLIC, as
 * labels_init. */
MUST_CHECK enum status push_init(struct push *p, const struct scene *scene,
                                 const struct monitor *monitor,
                                 struct fault *why);

/* From now on slip, time and mean friction come from fast_cells.h, and from
 * whole orbits only where that cannot tell: a state costs a fiftieth, the table
 * as much as some twenty whole orbits.  On error (STATUS_NO_MEMORY,
 * STATUS_STOPPED) they come from whole orbits as before. */
MUST_CHECK enum status push_tabulate(struct push *p,
                                     const struct monitor *monitor);

/* STATUS_BAD_ARGUMENT: the state is outside the domain (v, and psi unless a
 * logarithm, 1e-300..1e300); STATUS_NO_MEMORY; STATUS_STOPPED.  What does not
 * exist or cannot be followed is a reason in the answer. */
MUST_CHECK enum status push_find(const struct push *p, struct push_state at,
                                 const struct monitor *monitor,
                                 struct push_answer *out);

/* The same of many states, in parallel; out[count] the same at any number of
 * threads. */
MUST_CHECK enum status push_find_all(const struct push *p,
                                     const struct push_state at[], size_t count,
                                     const struct monitor *monitor,
                                     struct push_answer out[]);

/* Whether the state lies in the domain. */
bool push_holds(const struct push *p, struct push_state at);

/* A second call is harmless. */
void push_free(struct push *p);
