/* drawn.h -- beside a study of inputs X +- S the ensemble of the same numbers,
 * where draws are asked for: what `slipway ensemble` says of the scene. */
#pragma once

#include "ensemble.h"
#include "options.h"

/* STATUS_BAD_ARGUMENT: --draws, and no input is X +- S. */
MUST_CHECK enum status drawn_check(const struct options *o,
                                   const struct scene *scene,
                                   struct fault *why);

/* *e is empty (e->scene NULL) where the scene asks for no draws.  Errors of
 * ensemble_run; ensemble_free in any case. */
MUST_CHECK enum status drawn_run(const struct options *o,
                                 const struct scene *scene, struct ensemble *e,
                                 struct fault *why);

/* `e` itself; NULL: it is empty. */
const struct ensemble *drawn_of(const struct ensemble *e);
