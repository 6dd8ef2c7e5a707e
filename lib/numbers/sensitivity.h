/*
 * sensitivity.h -- how the critical velocities answer to the parameters:
 * d ln v_plus/d p and d ln v_minus/d p, exactly linearised along the branches
 * (variation.h), each with its error.
 */
#pragma once

#include "numbers.h"
#include "parameter.h"

/* Per unit of each parameter (alpha in rad), by enum parameter. */
struct sensitivity_numbers {
    struct quantity by[PARAMETERS];
};

struct sensitivities {
    struct sensitivity_numbers v_plus, v_minus;
};

struct sensitivities sensitivity_none(const char *reason);

/* Of the saddle e at b's anchor, to about rtol; c says which limits exist.
 * STATUS_NO_MEMORY, STATUS_BAD_ARGUMENT and STATUS_NOT_HYPERBOLIC as local_at
 * and grow_branch; then *out is undefined.  *evaluations grows by the field
 * evaluations; a jet counts as one a coefficient. */
MUST_CHECK enum status sensitivity_find(const struct block *b,
                                        const struct equilibrium *e,
                                        const struct critical_numbers *c,
                                        double rtol, struct sensitivities *out,
                                        size_t *evaluations);
