/* picture_transient.h -- the motion from each start as figures. */
#pragma once

#include "output.h"
#include "simulation.h"

/* The panels of Figs 14 and 15, one file each: NAME.svg is friction over slip,
 * the others are named NAME_time.svg, ... after these; ended by NULL. */
extern const char *const picture_simulation_panel[];

/* STATUS_BAD_ARGUMENT where no run has a length: there is nothing to draw. */
MUST_CHECK enum status picture_simulation_check(const struct simulation *s,
                                                struct fault *why);

/* Adds all panels. */
void picture_simulation(const struct simulation *s, struct panels *out);
