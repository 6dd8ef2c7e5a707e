/*
 * proof_cone.h -- the stable manifold beside the saddle, in a cone around the
 * polynomial p of its first piece.
 *
 * With M = f_ind/theta, D = step G(p) - p' and g = theta d(step G)/d dep: where
 *     M/step < 0   and   |D| < slope (1 - g)
 * on 0 < theta <= reach, |dep - p| <= slope theta, an orbit can leave that set
 * only through its sides |dep - p| = slope theta and enters it where theta =
 * reach; so one that starts there stays for ever (Wazewski), tends to the
 * saddle and is the stable manifold.
 */
#pragma once

#include "interval_tape.h"
#include "proof_tube.h"

/* Eigenvalues per t*. */
struct proof_saddle {
    struct interval lambda_minus, lambda_plus;
};

/* Eigenvalues, and that the equilibrium is a saddle: det J < 0. */
bool proof_is_saddle(struct interval_tape *t, struct proof_saddle *out);

/* d dep/d ind on 0 < theta <= reach, |dep - p| <= slope theta: finite, or all
 * there is. */
struct interval proof_cone_slope(struct interval_tape *t,
                                 const struct proof_piece *piece, double reach,
                                 double slope);

/* The cone on a piece that starts at the saddle: the longest found, reach <
 * most <= 1.  *front: what is proved at its end. */
bool proof_cone(struct interval_tape *t, const struct proof_piece *piece,
                double most, struct proof_cone *out, struct proof_front *front);
