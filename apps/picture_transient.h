/* picture_transient.h -- the motion from each start as figures. */
#ifndef APPS_PICTURE_TRANSIENT_H
#define APPS_PICTURE_TRANSIENT_H

#include "output.h"
#include "simulation.h"

/* The panels of Figs 14 and 15, one file each: NAME.svg is friction over slip,
 * the others are named NAME_time.svg, ... after these; ended by NULL. */
extern const char *const picture_simulation_panel[];

/* Adds all panels.  STATUS_BAD_ARGUMENT where no run has a length. */
MUST_CHECK enum status picture_simulation(const struct simulation *s,
                                          struct panels *p, struct fault *why);

#endif
