/* plane_numbers.h -- the numbers of a plane study that stand alone, in sweeps
 * and tables of checks: how many equilibria, cycles and attractors there are,
 * and the share of each equilibrium. */
#pragma once

#include "plane_study.h"
#include "result.h"
#include "result_number.h"

/* So many equilibria, and saddles among them, stand alone by their numbers; the
 * others are counted. */
enum { PLANE_RESTS_ALONE = 16, PLANE_SADDLES_ALONE = 8 };

/* Fills s->basin.elsewhere from s->basin.share, which is known. */
void plane_numbers_add(struct plane_study *s);

/* Fills s->count and the shares of its equilibria; the rest of *s is known. */
void plane_numbers_fill(struct plane_study *s);

/* What it fills, described. */
extern const struct result plane_number_results[];

/* A study of the scene that has no more than its tables, for the names of its
 * numbers; plane_numbers_free.  STATUS_NO_MEMORY leaves *frame empty. */
MUST_CHECK enum status plane_numbers_frame(struct plane_study *frame,
                                           const struct scene *scene);
void plane_numbers_free(struct plane_study *frame);

/* The names and places of all numbers of any study of this frame.
 * STATUS_NO_MEMORY leaves *n empty. */
MUST_CHECK enum status plane_numbers(struct result_numbers *n,
                                     const struct plane_study *frame);

/* Whether some of the window is undecided, which may be part of any of the
 * shares: of that their bars know nothing. */
bool plane_numbers_lack(const struct plane_study *s);
