/* ensemble_file.h -- an ensemble in an HDF5 file: every draw, and what all say
 * together. */
#pragma once

#include "ensemble.h"
#include "store.h"

/* Group /ensemble: along `draw` each parameter by the last word of its key,
 * each number with _error and _exists, the fate of each push as push_K; `id` of
 * samples that have one.  What they say together: /ensemble_numbers, _variance,
 * _pushes.  Draws go from the spool to the file block by block.  Errors as
 * result_file_write. */
MUST_CHECK enum status ensemble_file_put(const struct ensemble *e,
                                         struct store *out, struct fault *why);
