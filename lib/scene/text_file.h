/* text_file.h -- a whole file in memory. */
#pragma once

#include <stddef.h>

#include "status.h"

/* All bytes of path, "-" being standard input, and a zero behind them; where
 * they are more than `most`, the first of them, and *size says so by being more
 * than `most`.  *text is the caller's to free; NULL on failure: STATUS_IO, and
 * *why names path and reason; STATUS_NO_MEMORY. */
MUST_CHECK enum status text_file_read(const char *path, size_t most,
                                      char **text, size_t *size,
                                      struct fault *why);
