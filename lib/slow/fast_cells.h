/*
 * fast_cells.h -- what cells.h finds, the fast way: each state is followed only
 * until it falls onto the slow curve (fast_layer.h), whose time and slip are
 * tabulated once; where that cannot be done, as cells.h does.
 */
#pragma once

#include "patch.h"

struct fast_cells {
    const struct slider *slider; /* borrowed */
    struct slow_curve curve;     /* owned */
    int lanes;                   /* as of layer_width */
};

/* The table for a slider, and as many lanes as the
 * processor has.  STATUS_NO_MEMORY, STATUS_STOPPED: *f is empty. */
MUST_CHECK enum status fast_cells_init(struct fast_cells *f,
                                       const struct slider *s,
                                       const struct monitor *monitor);

/* As cells_find(f->slider, ...), to within both errors; the same bits whatever
 * the other states are.  *whole (may be NULL): how many states were left to
 * cells_find. */
MUST_CHECK enum status fast_cells_find(const struct fast_cells *f,
                                       const struct vec2 z[], size_t n,
                                       double rtol, unsigned which,
                                       const struct monitor *m,
                                       struct cell out[], size_t *whole);

/* For patches (patch.h): the cells of sample[].z about as accurately as rtol,
 * which is not made sure of, with slip where friction is asked for, their base
 * points, and v^2 at arrest; NaN where these pass a box of arrest.  Otherwise
 * as fast_cells_find. */
MUST_CHECK enum status fast_cells_sample(const struct fast_cells *f,
                                         struct patch_sample sample[], size_t n,
                                         double rtol, unsigned which);

/* What a base point says of the state z: slip, time and mean friction of those
 * fields.  False: not to be relied on (base_point.h). */
bool fast_cells_tell(const struct fast_cells *f, struct vec2 z,
                     const struct base_point *base, unsigned which,
                     struct cell *out);

/* The mean friction of the state z, and its error, from c's slip and v^2 at
 * arrest, units of V_star^2. */
void fast_cells_friction(const struct fast_cells *f, struct vec2 z, double left,
                         double left_error, struct cell *c);

/* Bits of enum cell_field: those that states of a fate have (cells.h). */
unsigned fast_cells_fields(const struct slider *s, enum fate fate);

/* A second call is harmless. */
void fast_cells_free(struct fast_cells *f);
