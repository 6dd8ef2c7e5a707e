/* export.h -- a study into an HDF5 file. */
#ifndef APPS_EXPORT_H
#define APPS_EXPORT_H

#include "study.h"

/* Writes all that the study holds to path, whole or not at all. */
MUST_CHECK enum status export_study(const struct study *s, const char *path,
                                    struct fault *why);

#endif
