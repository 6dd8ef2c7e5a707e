/*
 * portrait.h -- the phase portrait of a system in a window.
 *
 * Each part is built by its own call, so that who wants one pays for no other;
 * a second call replaces the part.  Every part counts its evaluations of the
 * field; those of a part never asked for are 0.
 */
#pragma once

#include "nullcline.h"
#include "trajectory.h"
#include "window.h"

/* The direction of a field at the cell centres of a grid. */
struct arrow {
    struct vec2 z;         /* absolute */
    struct vec2 direction; /* as it looks in the drawing (unit coordinates of
                              window.h), of length 1; 0 where the field is 0,
                              NaN where it is NaN */
    double log10_speed;    /* of |z'| in chart coordinates per unit of time;
                              -inf where the field is 0 */
};

struct arrows {
    struct arrow *at; /* owned; [column + row * columns], row 0 lowest */
    size_t columns, rows;
    size_t evaluations; /* of the field */
};

#define ARROWS_EMPTY ((struct arrows){ .at = NULL })

/* Cells are even in the drawing.  STATUS_BAD_ARGUMENT: window outside the
 * domain, no columns or rows; STATUS_NO_MEMORY.  Then *out is untouched. */
MUST_CHECK enum status arrows_find(const struct planar *system,
                                   const struct window *window, size_t columns,
                                   size_t rows, struct arrows *out);

/* A second call is harmless. */
void arrows_free(struct arrows *a);

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

/* Errors as in nullcline.h, arrows_find, trajectory.h; the portrait is then as
 * it was before the call. */
MUST_CHECK enum status portrait_find_nullclines(struct portrait *p,
                                                double chord);
MUST_CHECK enum status portrait_find_arrows(struct portrait *p, size_t columns,
                                            size_t rows);
MUST_CHECK enum status portrait_spread_trajectories(
    struct portrait *p, size_t count, const struct trajectory_options *options);

/* A second call is harmless. */
void portrait_free(struct portrait *p);
