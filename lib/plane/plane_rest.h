/* plane_rest.h -- the equilibria of a system of formulas in its window. */
#pragma once

#include "plane_study.h"

/* Fills s->rest, undecided and complete.  STATUS_NO_MEMORY; with *why,
 * STATUS_BAD_ARGUMENT. */
MUST_CHECK enum status plane_rest_find(struct plane_study *s,
                                       struct fault *why);

enum { PLANE_OUTSIDE = 64 };

/* Whether there is a trap about it, in this direction of time. */
bool plane_rest_attracts(const struct plane_rest *r, bool backward);

/* Whether it holds an absolute point. */
bool plane_rest_traps(const struct plane_study *s, const struct plane_rest *r,
                      bool backward, struct vec2 z);

/* The number of the equilibrium that Newton's steps from an absolute point
 * outside the window come to; one that is new is added where it is proved and
 * hyperbolic, up to PLANE_OUTSIDE of them: labels are bytes.  *index =
 * s->rests: there is none.  STATUS_NO_MEMORY. */
MUST_CHECK enum status plane_rest_add(struct plane_study *s, struct vec2 z,
                                      size_t *index);

/* How much longer than straight the way into it is, at most: a spiral's. */
double plane_rest_turns(const struct plane_rest *r);
