/* replace.h -- a file that appears whole or not at all.  Knows no format. */
#pragma once

#include <stddef.h>

#include "status.h"

/* Could replace_file(path) work: is the folder, or where it is missing the one
 * it can be made in, writable, and is `path` new or a regular file?  Changes
 * nothing.  STATUS_IO with the path and the system's reason in *fault. */
MUST_CHECK enum status replace_check(const char *path, struct fault *fault);

/* Makes the folder of `path`, and those it is in, where they are missing. */
MUST_CHECK enum status replace_folder(const char *path, struct fault *fault);

/* Makes the folder likewise; writes bytes[0 .. size-1] to a new file in the
 * folder of `path`, syncs it and renames it over `path`: at every moment, and
 * after a power cut, `path` is the old file (or none) or the whole new one.  Of
 * a symbolic link the file it names is replaced, not the link.  On STATUS_IO
 * the temporary file is gone and `path` untouched. */
MUST_CHECK enum status replace_file(const char *path, const void *bytes,
                                    size_t size, struct fault *fault);

/* The same for a file that is written piece by piece through a descriptor for
 * reading and writing: it takes its place at the end, if there was no error
 * (errno; any other number drops it), which is told.  replace_end leaves *r
 * NULL; a second call is harmless.  STATUS_IO, STATUS_NO_MEMORY. */
struct replacing;
MUST_CHECK enum status replace_begin(const char *path, struct replacing **r,
                                     struct fault *fault);
int replace_descriptor(const struct replacing *r);
MUST_CHECK enum status replace_end(struct replacing **r, int error,
                                   const char *path, struct fault *fault);
