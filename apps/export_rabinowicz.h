/* export_rabinowicz.h -- release distances and fits into an HDF5 file. */
#ifndef APPS_EXPORT_RABINOWICZ_H
#define APPS_EXPORT_RABINOWICZ_H

#include "release.h"

/* Of /rabinowicz/l_k and x_k. */
extern const struct record_type record_measured;

/* Writes r, of that scene, to path, whole or not at all: /rabinowicz/release,
 * and with data l_k, fit, slip, x_k and persistence beside it.  STATUS_IO,
 * STATUS_NO_MEMORY. */
MUST_CHECK enum status export_rabinowicz(const struct release *r,
                                         const struct scene *scene,
                                         const char *path, struct fault *why);

#endif
