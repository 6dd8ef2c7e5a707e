/* plane_rest.h -- the equilibria of a system of formulas in its window. */
#pragma once

#include "plane_study.h"

/* Fills s->rest, undecided and complete.  STATUS_NO_MEMORY; with *why,
 * STATUS_BAD_ARGUMENT. */
MUST_CHECK enum status plane_rest_find(struct plane_study *s,
                                       struct fault *why);
