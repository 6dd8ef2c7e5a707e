/* sweep_dim.h -- what a number of a sweep is given along beside the keys: the
 * starts of the scene, phases of sliding, the cells of a map. */
#pragma once

#include "scene.h"
#include "status.h"

enum sweep_dim {
    DIM_START, /* trajectories.starts */
    DIM_PHASE, /* phase.h */
    DIM_LEVEL, /* of |mu - tan(alpha)| */
    DIM_TERM,  /* of the power series, by order */
    DIM_CHI_ALPHA,
    DIM_PSI, /* cells of the basin map */
    DIM_V,
    DIM_ARROW_PSI, /* arrows of the direction field */
    DIM_ARROW_V,
    DIM_CHI_V,
    SWEEP_DIMS
};
enum { SWEEP_RANK = 2 }; /* of these, at most */

/* Its values, which are the same at all points. */
struct sweep_dim_axis {
    const char *name; /* "start" */
    const char *unit; /* UDUNITS; "1" if none */
    const char *text; /* one plain phrase */
    double *value;    /* owned */
    size_t count;     /* 0: the scene's products give nothing along it */
};

struct sweep_dims {
    struct sweep_dim_axis of[SWEEP_DIMS];
};

/* Those of the scene's products.  STATUS_NO_MEMORY leaves *d empty. */
MUST_CHECK enum status sweep_dims_init(struct sweep_dims *d,
                                       const struct scene *scene);

/* The dimensions "start, phase" of a result: "v" of one whose path is "/chi" is
 * chi_v, where there is such a one.  Their number. */
size_t sweep_dims_of(const char *axis, const char *path,
                     enum sweep_dim dim[SWEEP_RANK]);

/* A second call is harmless. */
void sweep_dims_free(struct sweep_dims *d);
