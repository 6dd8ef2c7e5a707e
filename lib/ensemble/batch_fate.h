/* batch_fate.h -- inside batch.c: the fates of the pushes at a draw. */
#pragma once

#include "batch.h"
#include "sweep_point.h"

void batch_fate_put(const struct batch_fates *f, size_t i, int8_t fate,
                    const char *reason);

/* Those of all b->push into f[pushes] at draw i, of whose law and slope the
 * point's study knows the steady states, by the sides of the separatrix
 * (labels.h): of the curve that its numbers came from, or where that leaves
 * doubt of one grown as `push` grows it. STATUS_NO_MEMORY, STATUS_STOPPED, or
 * as labels_init. */
MUST_CHECK enum status batch_fate_find(const struct batch *b,
                                       const struct sweep_point *p, size_t i,
                                       const struct monitor *monitor,
                                       const struct batch_fates f[]);
