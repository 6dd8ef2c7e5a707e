/* export_workprec.h -- work-precision diagrams into an HDF5 file. */
#ifndef APPS_EXPORT_WORKPREC_H
#define APPS_EXPORT_WORKPREC_H

#include "workprec.h"

/* Writes w to path, whole or not at all: /workprec/runs, /workprec/fastest,
 * /workprec/environment, and why a quantity has no runs as attributes of
 * /workprec.  STATUS_IO, STATUS_NO_MEMORY. */
MUST_CHECK enum status export_workprec(const struct workprec *w,
                                       const char *path, struct fault *why);

#endif
