/*
 * grow_error.h -- what the numbers of a growing branch are off by: an estimate
 * with its sign, a bound on what that leaves, and roundings.
 */
#pragma once

#include "grower.h"

/* |off| + bar + the roundings: no less than the error. */
double grow_error_bound(const struct grow_miss *m);

/* From the field at the end of the last step, z: g->out. */
void grow_error_look(struct grower *g, struct vec2 z);

/* The same curve as another graph: an error of dep becomes `turned` times as
 * much, and what it was `ahead` by along what the old graph is over. */
void grow_error_turn(struct grower *g, double turned, double ahead);

/* Beyond the last step: an error of dep becomes `grown` times as much and adds
 * drift[i] times as much to integral i's. */
void grow_error_tail(struct grower *g, double grown, const double drift[]);

/* The step to g->at_end, where the field is g->end: its own errors, and what
 * becomes of those before it. */
void grow_error_step(struct grower *g);
