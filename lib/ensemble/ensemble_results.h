/* ensemble_results.h -- what an ensemble has beside the columns of its draws,
 * described (result.h). */
#pragma once

#include "result.h"

/* Results whose run is a struct ensemble. */
extern const struct result *const ensemble_tables[];
