/*
 * quad_block.h -- the 113-bit oracle: the law's formulas as typed
 * (law_tape.h).  Same chart, same meaning of every argument as in block.h; x =
 * ln v.
 */
#pragma once

#include "block.h"
#include "quad_tape.h"

struct quad_anchor {
    quad x0, y0, v0, psi0, mu0, force0; /* as in steady.h */
    struct quad_tape tape;              /* of the law */
};

/* The field: (direction_x, direction_y) * exp(log_scale). */
struct quad_field {
    quad direction[2], log_scale;
};

/* mu_ss(v), and the chart's y at psi_ss(v). */
quad quad_block_mu_ss(const struct law *law, const struct material *m, quad x);
quad quad_block_y_ss(const struct law *law, const struct material *m, quad x);

/* The steady state mu_ss(v) = tan(alpha) between lo and hi, where
 * mu_ss - tan(alpha) must have opposite signs, by bisection to the last bit. */
quad quad_block_equilibrium(const struct law *law, const struct material *m,
                            quad tan_alpha, quad lo, quad hi);

/* The point x of the steady-state curve; `equilibrium` as in block_anchor. */
void quad_block_anchor(const struct law *law, const struct material *m,
                       quad tan_alpha, quad x, bool equilibrium,
                       struct quad_anchor *at);

/* The field and the rate of an observable at an offset from the anchor. */
void quad_block_field(const struct quad_anchor *at, quad X, quad Y,
                      struct quad_field *f);
quad quad_block_rate(const struct quad_anchor *at, enum block_observable which,
                     quad X, quad Y);

/* mu(v, psi) there. */
quad quad_block_mu(const struct quad_anchor *at, quad X, quad Y);
