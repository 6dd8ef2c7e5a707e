/* side_file.h -- the file beside the result of a long run, FILE.h5.part: what
 * is computed stays there until all is written. */
#pragma once

#include "output.h"

/* FILE.h5.part of the scene's file, owned by the caller; NULL without a file or
 * memory. */
char *side_file_of(const struct scene *c);

/* output_check, and with --resume what there is to go on with: the side file
 * says what it is of; where there is none, a file that was finished is of this
 * command and scene. */
MUST_CHECK enum status side_file_check(const struct options *o,
                                       const struct scene *c,
                                       const char *command, const char *journal,
                                       const char *const panel[],
                                       struct fault *why);
