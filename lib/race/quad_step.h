/* quad_step.h -- one step of an ordinary differential equation in 113 bits. */
#ifndef RACE_QUAD_STEP_H
#define RACE_QUAD_STEP_H

#include "quad.h"

enum { QUAD_DIM = 2 };

/* dy/ds at (s, y). */
typedef void quad_rates(const void *ctx, quad s, const quad y[QUAD_DIM],
                        quad dy[QUAD_DIM]);

/* How fast a step's error grows with its length: like length to this power. */
enum { QUAD_STEP_ORDER = 19 };

/* From y at s to out at s + h; error[i]: the last correction to out[i], of
 * which the true error is a small part, or more where a rate has decayed
 * between any two substeps.  112 evaluations.  Nothing is finite where the
 * rates are not. */
void quad_step(quad_rates *f, const void *ctx, quad s, quad h,
               const quad y[QUAD_DIM], quad out[QUAD_DIM],
               quad error[QUAD_DIM]);

#endif
