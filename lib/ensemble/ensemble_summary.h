/* ensemble_summary.h -- inside ensemble.c: what the draws of the spool say
 * together. */
#pragma once

#include "ensemble.h"

/* Fills e->number and e->push.  STATUS_IO, STATUS_NO_MEMORY. */
MUST_CHECK enum status ensemble_summary(struct ensemble *e, struct fault *why);
