/* quad_knee.h -- where d ln psi/d ln v passes through 1 on a branch, in 113
 * bits: what the bars of manifold/knee.h are held to. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "quad.h"

enum { QUAD_KNEES = 16 };

struct quad_knee {
    quad z[2];   /* offset from the saddle */
    quad error;  /* of both: what a relative error of 1e-18 in the curve does */
    bool rising; /* the slope grows through 1, going outward */
};

struct quad_knees {
    struct quad_knee at[QUAD_KNEES];
    size_t count; /* may be larger than QUAD_KNEES: the others are not kept */
};

/* A piece of a curve: its point and the outward direction there at a part
 * 0 ... 1 of it; `rough`: about, and cheap. */
struct quad_arc {
    void (*at)(const void *ctx, bool rough, quad part, quad z[2], quad way[2]);
    const void *ctx;
};

/* Adds the crossings on the arc, to the last bits. */
void quad_knee_add(const struct quad_arc *arc, struct quad_knees *out);
