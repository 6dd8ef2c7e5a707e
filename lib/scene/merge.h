/* merge.h -- a scene and its overrides as one text. */
#pragma once

#include "status.h"

/* Writes the YAML of `text` (a scene file; "" for none) with `overrides` (one
 * "key=value" a line, in order) put in.  Without overrides the text itself;
 * else it is written anew, without its comments.  Reading the result gives the
 * same scene.  *merged is owned by the caller.
 *
 * STATUS_BAD_SCENE with one line in *why, STATUS_NO_MEMORY; *merged is
 * untouched then. */
MUST_CHECK enum status scene_merge(const char *text, const char *overrides,
                                   char **merged, struct fault *why);
