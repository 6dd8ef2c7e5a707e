/*
 * trap.h -- labels of states by forward integration that ends early: the
 * quadrants v < v_sp, psi > psi_sp and v > v_sp, psi < psi_sp of the saddle
 * cannot be left where mu grows with psi and psi_ss falls with v, so the fate
 * of an orbit is that of the quadrant it enters.  Shares nothing with the
 * separatrix but the field: the independent check of basin maps.
 */
#pragma once

#include "fate.h"

enum { TRAPS = 2 };

struct trap {
    const struct slider *slider; /* borrowed */
    bool set;                    /* there is a saddle */
    int8_t fate[TRAPS];          /* of the slow and the fast quadrant */
    struct vec2 across;          /* unit; normal to the stable manifold at the
                                    saddle, which may lie almost on an axis */
};

/* For s, whose steady states are known. */
void trap_init(struct trap *t, const struct slider *s);

/* The label (enum fate) of the offset z from the saddle, right unless z lies
 * within rounding of the boundary: an orbit that passes the saddle too closely
 * for its accuracy is followed again, more accurately.  *evaluations (may be
 * NULL) is increased by those of the field.  Errors as fate_find. */
MUST_CHECK enum status trap_label(const struct trap *t, struct vec2 z,
                                  int8_t *label, size_t *evaluations);

/* The same, and how near the saddle the orbit passes, in the chart, or may pass
 * still: its distance from the stable manifold, straightened, where a trap
 * catches it.  Infinite without a saddle. */
MUST_CHECK enum status trap_pass(const struct trap *t, struct vec2 z,
                                 int8_t *label, double *near,
                                 size_t *evaluations);
