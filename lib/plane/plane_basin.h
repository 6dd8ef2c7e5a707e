/*
 * plane_basin.h -- whereto the states of a window go: regions between the
 * stable manifolds of all saddles and the cycles that repel, each labelled by
 * orbits, and the share of each attractor.
 */
#pragma once

#include "plane_study.h"

/* Fills s->basin; the branches are known.  STATUS_NO_MEMORY, STATUS_STOPPED;
 * STATUS_BAD_SCENE: more than INT8_MAX attractors, labels are bytes. */
MUST_CHECK enum status plane_basin_find(struct plane_study *s,
                                        const struct monitor *monitor);

/* A second call is harmless. */
void plane_basin_free(struct plane_basin *b);
