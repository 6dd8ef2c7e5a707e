/*
 * slipway_planar.h -- an analytic system of one's own in a window of the plane:
 * its equilibria and the invariant manifolds of its saddles.
 *
 *     static void pendulum(void *ctx, slipway_form *f, slipway_term x,
 *                          slipway_term y, slipway_term rate[2])
 *     {
 *         rate[0] = y;
 *         rate[1] = slipway_neg(f, slipway_sin(f, x));
 *     }
 *     ...
 *     slipway_window w = { { -4, -3 }, { 4, 3 } };
 *     slipway_plane_open(pendulum, NULL, &w, &plane, &why);
 *     slipway_plane_branch(plane, 0, SLIPWAY_STABLE, +1, 1e-12, out, room, &n);
 *
 * The function is called once and says how the rates are built; they are then
 * evaluated as numbers, derivatives and Taylor series.
 */
#ifndef SLIPWAY_SLIPWAY_PLANAR_H
#define SLIPWAY_SLIPWAY_PLANAR_H

#include "slipway.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct slipway_form slipway_form;
typedef int32_t slipway_term;

typedef enum slipway_operation {
    SLIPWAY_OP_ADD,
    SLIPWAY_OP_SUB,
    SLIPWAY_OP_MUL,
    SLIPWAY_OP_DIV,
    SLIPWAY_OP_EXP,
    SLIPWAY_OP_LOG,
    SLIPWAY_OP_SQRT,
    SLIPWAY_OP_SIN,
    SLIPWAY_OP_COS
} slipway_operation;

/* A constant; and what an operation makes of a (and b; functions of one take
 * b = a). */
slipway_term slipway_constant(slipway_form *form, double value);
slipway_term slipway_operate(slipway_form *form, slipway_operation operation,
                             slipway_term a, slipway_term b);

#define SLIPWAY_OF_TWO(name, op)                                               \
    static inline slipway_term slipway_##name(slipway_form *f, slipway_term a, \
                                              slipway_term b)                  \
    {                                                                          \
        return slipway_operate(f, op, a, b);                                   \
    }
SLIPWAY_OF_TWO(add, SLIPWAY_OP_ADD)
SLIPWAY_OF_TWO(sub, SLIPWAY_OP_SUB)
SLIPWAY_OF_TWO(mul, SLIPWAY_OP_MUL)
SLIPWAY_OF_TWO(div, SLIPWAY_OP_DIV)
#undef SLIPWAY_OF_TWO

#define SLIPWAY_OF_ONE(name, op)                                               \
    static inline slipway_term slipway_##name(slipway_form *f, slipway_term a) \
    {                                                                          \
        return slipway_operate(f, op, a, a);                                   \
    }
SLIPWAY_OF_ONE(exp, SLIPWAY_OP_EXP)
SLIPWAY_OF_ONE(log, SLIPWAY_OP_LOG)
SLIPWAY_OF_ONE(sqrt, SLIPWAY_OP_SQRT)
SLIPWAY_OF_ONE(sin, SLIPWAY_OP_SIN)
SLIPWAY_OF_ONE(cos, SLIPWAY_OP_COS)
#undef SLIPWAY_OF_ONE

static inline slipway_term slipway_neg(slipway_form *f, slipway_term a)
{
    return slipway_sub(f, slipway_constant(f, 0.0), a);
}

/* Builds rate[0] = dx/dt and rate[1] = dy/dt. */
typedef void slipway_rates(void *ctx, slipway_form *form, slipway_term x,
                           slipway_term y, slipway_term rate[2]);

typedef struct slipway_window {
    double lo[2], hi[2];
} slipway_window;

typedef struct slipway_rest {
    double x, y;
    double error; /* bound on the distance to it: twice one more Newton step,
                     and rounding */
    double re[2], im; /* eigenvalues re[0] +- i im, or re[0] <= re[1], im = 0 */
} slipway_rest;

typedef enum slipway_kind { SLIPWAY_STABLE, SLIPWAY_UNSTABLE } slipway_kind;

typedef struct slipway_place {
    double x, y, error; /* bound on the distance to the exact curve */
} slipway_place;

typedef struct slipway_plane slipway_plane;

/* BAD_ARGUMENT: an empty window, a rate that is not a term, or more than 62
 * constants and operations; NO_MEMORY.  `rates` is called once, here; neither
 * it nor ctx is kept. */
slipway_status slipway_plane_open(slipway_rates *rates, void *ctx,
                                  const slipway_window *window,
                                  slipway_plane **out, slipway_fault *why);

/* The number of equilibria that Newton's method finds in the window from a grid
 * of 32 x 32 (that there are no others is not proved), ascending in x, then y;
 * the first `room` of them into out[]. */
size_t slipway_plane_equilibria(const slipway_plane *plane, slipway_rest out[],
                                size_t room);

/* Half of a manifold of equilibrium number `which`, from there to the window's
 * edge, or as far as the allowed steps go, where it winds or nears another
 * equilibrium: the side of growing (+1) or falling (-1) x, or y where it leaves
 * vertically.  rtol: asked of its points, relative to their distance from the
 * equilibrium.  *count: its points, the first `room` of them in out[].
 * BAD_ARGUMENT: no such equilibrium, side not 1 or -1, rtol not in (0, 1);
 * NUMERICAL: it is no hyperbolic saddle, or no step is short enough. */
slipway_status slipway_plane_branch(const slipway_plane *plane, size_t which,
                                    slipway_kind kind, int side, double rtol,
                                    slipway_place out[], size_t room,
                                    size_t *count);

void slipway_plane_free(slipway_plane *plane);

#ifdef __cplusplus
}
#endif

#endif
