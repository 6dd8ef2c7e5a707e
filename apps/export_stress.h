/* export_stress.h -- the catalogue's results into an HDF5 file. */
#ifndef APPS_EXPORT_STRESS_H
#define APPS_EXPORT_STRESS_H

#include "stress_run.h"

/* Writes the columns of record_stress to /stress of `path`, whole or not at
 * all, and what made the file to /provenance. */
MUST_CHECK enum status export_stress(const struct stress *s, const char *path,
                                     struct fault *why);

#endif
