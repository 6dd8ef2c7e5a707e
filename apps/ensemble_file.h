/* ensemble_file.h -- an ensemble as an HDF5 file: every draw, and what all say
 * together. */
#pragma once

#include "ensemble.h"
#include "result.h"
#include "store.h"

/* For the reference pages. */
extern const struct result *const ensemble_tables[];

/* Group /ensemble: along `draw` each parameter by the last word of its key,
 * each number with _error and _exists, the fate of each push as push_K; `id` of
 * samples that have one.  What they say together: /ensemble_numbers, _variance,
 * _pushes.  Draws go from the spool to the file block by block.  Errors as
 * result_file_write. */
MUST_CHECK enum status ensemble_file_write(const struct ensemble *e,
                                           const char *path, struct fault *why);

/* The same groups, in a file of more. */
MUST_CHECK enum status ensemble_file_put(const struct ensemble *e,
                                         struct store *out, struct fault *why);
