/*
 * variation.h -- how a branch of a saddle's stable manifold moves when
 * parameters of the field change.
 *
 * With the branch as the graph dep(ind; p) of one coordinate over the other
 * and S = f_dep/f_ind its slope, eta = d dep/d p at fixed ind obeys
 *     d eta/d ind = S_dep eta + S_p,   S_p = (f_dep,p - S f_ind,p)/f_ind,
 * which at the saddle has one bounded solution,
 *     eta = dz_dep - dep'(0) dz_ind,   Df dz = -f_p  (the saddle's motion).
 */
#pragma once

#include "branch.h"

enum { VARIATION_MAX = 8, VARIATION_NODES_MAX = 12 };

/* The parameters: d f/d p * exp(-f->log_scale) for `count` of them at the
 * offset z, where f is the field; the origin does not move. */
struct variation {
    size_t count; /* at most VARIATION_MAX */
    void (*gradient)(const void *ctx, struct vec2 z,
                     const struct planar_field *f, struct vec2 out[]);
    const void *ctx; /* borrowed */
    size_t nodes;    /* Gauss points a piece, 2..VARIATION_NODES_MAX */
    double tol;      /* pieces are halved until what is left, relative, is
                        about this */
};

/* Along the branch's curve.  end[i]: eta at the end of the branch's curve, of x
 * where that is a graph over y and of y where it is one over x; rest[i]: |d
 * eta/d ind| there, about what a branch with a limit leaves out.  Not finite
 * where the field's derivatives are not. */
void variation_along(const struct planar *sys, const struct branch *b,
                     const struct variation *v, double end[], double rest[]);
