/*
 * fast_cells.h -- what cells.h finds, the fast way: each state is followed only
 * until it falls onto the slow curve (fast_layer.h), whose time and slip are
 * tabulated once; where that cannot be done, as cells.h does.
 */
#ifndef STUDY_FAST_CELLS_H
#define STUDY_FAST_CELLS_H

#include "cells.h"
#include "slow_curve.h"

struct fast_cells {
    const struct study *study; /* borrowed */
    struct slow_curve curve;   /* owned */
    int lanes; /* as of layer_lanes_width; 1: one state after the other */
};

/* The table for a study whose steady states are known, and as many lanes as the
 * processor has.  STATUS_NO_MEMORY, STATUS_STOPPED: *f is empty. */
MUST_CHECK enum status fast_cells_init(struct fast_cells *f,
                                       const struct study *s,
                                       const struct monitor *monitor);

/* As cells_find(f->study, ...), to within both errors; the same bits whatever
 * the other states are.  *whole (may be NULL): how many states were left to
 * cells_find. */
MUST_CHECK enum status fast_cells_find(const struct fast_cells *f,
                                       const struct vec2 z[], size_t n,
                                       double rtol, unsigned which,
                                       const struct monitor *m,
                                       struct cell out[], size_t *whole);

/* A second call is harmless. */
void fast_cells_free(struct fast_cells *f);

#endif
