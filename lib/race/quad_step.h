/* quad_step.h -- one step of an ordinary differential equation in 113 bits. */
#pragma once

#include <stdbool.h>

#include "quad.h"

enum { QUAD_DIM = 2, QUAD_STEP_COLUMNS = 10 };

/* dy/ds at (s, y). */
typedef void quad_rates(const void *ctx, quad s, const quad y[QUAD_DIM],
                        quad dy[QUAD_DIM]);

struct quad_step {
    int columns;  /* extrapolations made: as few as were enough */
    double blind; /* above 1: the rates may have decayed between substeps */
};

/* From y at s to out at s + h; error[i]: the last correction to out[i], of
 * which the true error is a small part, or more where it is small by chance or
 * where a rate has decayed between any two substeps.  enough[i]: no better than
 * this is asked for.  18 to 102 evaluations.  Nothing is finite where the rates
 * are not. */
struct quad_step quad_step(quad_rates *f, const void *ctx, quad s, quad h,
                           const quad y[QUAD_DIM], const quad enough[QUAD_DIM],
                           quad out[QUAD_DIM], quad error[QUAD_DIM]);

/* What to multiply the step by, when its error is `error` of what is allowed:
 * that grows like the step to the power 2 columns - 1. */
double quad_step_factor(const struct quad_step *step, double error);
