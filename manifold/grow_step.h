/*
 * grow_step.h -- the next steps of n <= GROWERS growers whose planes are alike,
 * side by side, by their series.
 */
#pragma once

#include "grower.h"

/* How long: g->h, and g->edge. */
void grow_step_choose(struct grower *const g[], size_t n);

/* What their ends are: g->end, at_end, dep_end and integral_end. */
void grow_step_look(struct grower *const g[], size_t n);

/* The same, and whether the steps hold: g->holds, and g->kink. */
void grow_step_try(struct grower *const g[], size_t n);
