/* export.h -- a study into an HDF5 file. */
#ifndef APPS_EXPORT_H
#define APPS_EXPORT_H

#include "store.h"
#include "study.h"

/* Writes all that the study holds to path, whole or not at all; the rows of a
 * basin map are computed on the way.  `monitor` may be NULL. */
MUST_CHECK enum status export_study(const struct study *s, const char *path,
                                    const struct monitor *monitor,
                                    struct fault *why);

/* What every result file says of its making, into /provenance: scene,
 * overrides, version, compiler, libraries, law and material. */
MUST_CHECK enum status export_provenance(const struct scene *scene,
                                         struct store *out);

#endif
