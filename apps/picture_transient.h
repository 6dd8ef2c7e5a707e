/* picture_transient.h -- runs as figures. */
#ifndef APPS_PICTURE_TRANSIENT_H
#define APPS_PICTURE_TRANSIENT_H

#include "simulation.h"

enum { PICTURE_PATH = 4096 };

/* NAME.svg -> NAME_time.svg; false where that is too long. */
bool picture_time_path(const char *path, char out[PICTURE_PATH]);

/* Draws friction against slip into path (.svg, .pdf, .png) and slip rate
 * against time into its picture_time_path; errors as figure_write. */
MUST_CHECK enum status picture_simulation(const struct simulation *s,
                                          const char *path, bool keep_script,
                                          struct fault *why);

#endif
