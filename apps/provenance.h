/* provenance.h -- what every result file says of its making, into /provenance:
 * no clock, path, host or thread count. */
#pragma once

#include "result.h"
#include "scene.h"
#include "store.h"

/* For the reference pages; also what store.h puts at the root. */
extern const struct result *const provenance_tables[];

/* command: that makes the file again; scene: NULL, where a file is of none.
 * Errors of store.h. */
MUST_CHECK enum status provenance_put(const char *command,
                                      const struct scene *scene,
                                      struct store *out);

/* The settings that are written there: all but those of the output, for where a
 * file lies is not part of what it holds.  Owned by the caller; NULL without
 * memory. */
char *provenance_overrides(const struct scene *scene);
