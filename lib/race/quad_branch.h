/*
 * quad_branch.h -- a branch of the saddle's stable manifold in 113 bits: what
 * the bars of manifold/ are held to.  Slow (some 10^4 field evaluations), by
 * another method from another start to another end.
 */
#pragma once

#include "quad_block.h"
#include "quad_knee.h"

enum quad_end {
    QUAD_PSI_INF,  /* psi -> inf, v -> v_0 e^x */
    QUAD_OPEN,     /* psi -> inf, v without a limit: followed to e^700, or
                      by 600 where psi is a logarithm */
    QUAD_PSI_0,    /* psi -> 0 (-inf where it is a logarithm), v -> v_0 e^x */
    QUAD_V_0,      /* v -> 0, chart y -> y_0 + y */
    QUAD_TRUNCATED /* anything else, or given up */
};

enum { QUAD_PATH = 512 };

struct quad_branch {
    const struct quad_anchor *at; /* borrowed: the saddle */
    enum quad_end end;
    quad x, y;   /* offsets from the saddle at the end; see quad_end */
    quad excess; /* integral of (v - v_0) dt along the branch, from its far end
                    to the saddle: x_excess, or -x_deficit */
    quad error, excess_error; /* of the limit and of the integral, relative to
                                 the limit's offset, to the integral */
    struct quad_knees knees;  /* from the saddle outward */
    size_t steps, evaluations;
    size_t points; /* on the way, its end included: offsets from the saddle */
    quad path[QUAD_PATH][2];
};

/* The branch v > v_0 (side +1) or v < v_0 (-1) of the saddle at->x0, which
 * quad_block_anchor has prepared as an equilibrium.  tol: error of a step,
 * relative to the offsets from the saddle; 1e-18 is good for every bar of a
 * double, 1e-28 is the end.  False, with *out undefined, where it is no
 * saddle. */
bool quad_branch_grow(const struct law *law, const struct quad_anchor *at,
                      int side, double tol, struct quad_branch *out);
