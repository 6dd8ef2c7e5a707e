/* child.h -- a file that others made is read in a process of its own.
 *
 * libhdf5 may crash, hang or eat memory over a damaged or hostile file, and
 * nothing in this program can stop it.  So a child reads the file and hands
 * back plain bytes; its death is an error like another. */
#pragma once

#include <stdio.h>

#include "status.h"

/* Reads what is wanted with store_read.h or store_compare.h and writes it to
 * `out`, in the child: what else it changes in memory is lost with it, and its
 * standard error leads nowhere. */
typedef enum status child_work(void *ctx, FILE *out, struct fault *why);

/* What the work, which reads the file `path`, writes comes back in *bytes,
 * owned by the caller (free), with a zero after the last of *size; its status
 * and *why come back too.
 *
 * STATUS_IO and one line in *why where the child dies, takes longer than
 * `seconds` or needs more than CHILD_BYTES; STATUS_NO_MEMORY.  On failure
 * *bytes is NULL. */
MUST_CHECK enum status child_read(child_work *work, void *ctx, const char *path,
                                  unsigned seconds, char **bytes, size_t *size,
                                  struct fault *why);
