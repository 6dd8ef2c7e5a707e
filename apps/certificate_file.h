/* certificate_file.h -- the file that --certificate asks for. */
#pragma once

#include "json.h"
#include "options.h"
#include "scene.h"

/* Whether --certificate, if it is given, can be followed: something is proved,
 * and the file can be written. */
MUST_CHECK enum status certificate_check(const struct options *o,
                                         const struct scene *scene,
                                         struct fault *why);

/* Writes the file that is asked for, whole or not at all, and says so.  Steals
 * proof. */
MUST_CHECK enum status certificate_write(const struct options *o, json_t *proof,
                                         struct fault *why);
