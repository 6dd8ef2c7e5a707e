/* equilibrium.h -- zeros of a planar system and their linear type. */
#pragma once

#include "planar.h"
#include "status.h"

enum { EQUILIBRIA_MAX = 5 }; /* monotone pieces of a steady curve */

enum equilibrium_type {
    EQUILIBRIUM_SADDLE,
    EQUILIBRIUM_STABLE_NODE,
    EQUILIBRIUM_SADDLE_NODE, /* one eigenvalue is zero: at a fold */
    EQUILIBRIUM_UNSTABLE_NODE,
    EQUILIBRIUM_FOCUS
};
extern const char *const equilibrium_type_names[];

struct equilibrium {
    enum equilibrium_type type;
    struct vec2 z;      /* absolute coordinates */
    double lambda[2];   /* ascending, per unit of the system's time; real parts
                           of a focus; may be infinite */
    struct mat2 matrix; /* Df = matrix * exp(log_scale) */
    double scaled[2];   /* eigenvalues of `matrix`, ascending */
    double log_scale;
};

/* A zero of the balance along the steady curve. */
struct steady_root {
    long double x;
    bool fold;      /* a turning point that just touches zero */
    bool rises;     /* the balance, as it does at a saddle */
    long double hi; /* it is in [x, hi], if that is more than x: not closed, */
    long double at[2]; /* where the balance is these */
};

/* Every zero of the curve's balance in [lo, hi], ascending: one in each
 * monotone piece whose ends differ in sign, to the last bit of a long double;
 * ctx is the balance's.  Returns their number, at most EQUILIBRIA_MAX. */
size_t equilibrium_find(const struct planar_steady *s, const void *ctx,
                        struct steady_root root[EQUILIBRIA_MAX]);

/* The same in two steps: where they are, and each of them. */
size_t equilibrium_bracket(const struct planar_steady *s, const void *ctx,
                           struct steady_root root[EQUILIBRIA_MAX]);
void equilibrium_close(const struct planar_steady *s, const void *ctx,
                       struct steady_root *root);

/* Linear type of the equilibrium at sys->origin.  `fold`: one eigenvalue is
 * known to be zero.  Where one has left the doubles, sys->steady, if there is
 * one, tells a saddle, at which the balance rises, from a node. */
void equilibrium_at(const struct planar *sys, bool fold,
                    struct equilibrium *out);

/* Whether the eigenvalues are further apart than doubles can tell: the smaller
 * one is not zero, but its `scaled` has no digits. */
bool equilibrium_is_beyond(const struct equilibrium *e);
