/* draws_table.h -- inside draws.c: the files of an ensemble. */
#pragma once

#include "draws.h"

/* A column for each key, "material.L" or "material.L [m]" with its unit, and
 * perhaps one `id`; numbers in the scene's units, those of keys that may have
 * one behind them with theirs.  Errors as draws_init; *d is not freed. */
MUST_CHECK enum status draws_read_samples(struct draws *d,
                                          const struct scene *scene,
                                          struct fault *why);

/* Columns key, mean, and one for each key, in any order; a row each, of which
 * the covariances are symmetric and positive definite.  The same. */
MUST_CHECK enum status draws_read_covariance(struct draws *d,
                                             const struct scene *scene,
                                             struct fault *why);
