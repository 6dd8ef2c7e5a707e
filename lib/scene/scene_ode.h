/* scene_ode.h -- a model of XPPAUT (xpp_model.h) as the text of a scene. */
#pragma once

#include <stdbool.h>

#include "status.h"

/* Whether it is called NAME.ode. */
bool scene_is_ode(const char *path);

/* The scene in *scene, the caller's to free, of a model's text; `path` stands
 * in messages and in the title.  STATUS_BAD_SCENE with one line,
 * STATUS_NO_MEMORY; *scene is then untouched. */
MUST_CHECK enum status scene_of_ode(const char *path, const char *text,
                                    char **scene, struct fault *why);
