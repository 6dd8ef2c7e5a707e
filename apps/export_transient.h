/* export_transient.h -- the runs of a scene into an HDF5 file. */
#ifndef APPS_EXPORT_TRANSIENT_H
#define APPS_EXPORT_TRANSIENT_H

#include "simulation.h"

/* Points of a table where the scene does not say. */
enum { EXPORT_SAMPLES = 201 };

/* Writes /provenance and for each run /trajectory_k (a few points a step), its
 * linear_slip and log_time tables (the one the scene asks for; both where it
 * asks for neither), its summary, events and phases; whole or not at all.
 * Errors of store.h. */
MUST_CHECK enum status export_simulation(const struct simulation *s,
                                         const char *path, struct fault *why);

#endif
