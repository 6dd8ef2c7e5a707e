/* origin.h -- what a result file says of its making (provenance.h), read back.
 * The file may be anyone's: a child reads it (child.h). */
#pragma once

#include "status.h"

struct origin {
    char *command, *scene, *overrides; /* borrowed */
    char *held;                        /* owned; free() */
};

/* Whether files of this command will do; if not, a status and *why. */
typedef enum status origin_suits(const char *path, const char *command,
                                 struct fault *why);

/* STATUS_IO where the file cannot be read or does not say; what `suits` says;
 * *out is then empty. */
MUST_CHECK enum status origin_read(const char *path, origin_suits *suits,
                                   struct origin *out, struct fault *why);
