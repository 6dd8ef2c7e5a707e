/* picture_transient.h -- the motion from each start as figures. */
#ifndef APPS_PICTURE_TRANSIENT_H
#define APPS_PICTURE_TRANSIENT_H

#include "simulation.h"

/* The panels of Figs 14 and 15, one file each: NAME.svg is friction over slip,
 * the others are named NAME_time.svg, ... after these. */
enum { PICTURE_PANELS = 5 };
extern const char *const picture_transient_panel[PICTURE_PANELS];

/* Draws all panels.  Errors as figure_write; STATUS_BAD_ARGUMENT also where no
 * run has a length. */
MUST_CHECK enum status picture_simulation(const struct simulation *s,
                                          const char *path, bool keep_script,
                                          struct fault *why);

#endif
