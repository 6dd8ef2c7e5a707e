/*
 * portrait.h -- the phase portrait of a system in a window.
 *
 * Each part is built by its own call, so that who wants one pays for no other;
 * a second call replaces the part.  Every part counts its evaluations of the
 * field; those of a part never asked for are 0.
 */
#pragma once

#include "arrows.h"
#include "nullcline.h"
#include "trajectory.h"

struct portrait {
    const struct planar *system; /* borrowed */
    struct window window;
    struct nullcline nullcline[NULLCLINES]; /* owned */
    struct arrows arrows;                   /* owned */
    struct trajectories trajectories;       /* owned */
};

/* An empty portrait.  STATUS_BAD_ARGUMENT: window outside the domain; nothing
 * to free then, though portrait_free is harmless. */
MUST_CHECK enum status portrait_init(struct portrait *p,
                                     const struct planar *system,
                                     const struct window *window);

/* Errors as in nullcline.h, arrows.h, trajectory.h; the portrait is then as it
 * was before the call. */
MUST_CHECK enum status portrait_find_nullclines(struct portrait *p,
                                                double chord);
MUST_CHECK enum status portrait_find_arrows(struct portrait *p, size_t columns,
                                            size_t rows);
MUST_CHECK enum status portrait_spread_trajectories(
    struct portrait *p, size_t count, const struct trajectory_options *options);

/* A second call is harmless. */
void portrait_free(struct portrait *p);
