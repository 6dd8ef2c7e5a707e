/*
 * proof_end.h -- what is left of a branch beyond its last cell, by what is
 * known of every law (proof_law.h): where psi > psi_ss(v) and mu > tan(alpha)
 * an orbit comes from larger v and psi, where both are less it comes from
 * smaller ones (docs/proofs.md); and bounds on how far.  Offsets X, Y; d = psi
 * - psi_ss(v); F = cos(alpha)/eps^2, so that d ln v/dt = -(F/v) (mu -
 * tan(alpha)).
 */
#pragma once

#include "proof_cell.h"

/* A place on a branch, and on which side of the saddle it is. */
struct proof_place {
    struct interval X, Y;
    int side;
};

/* On a piece, within `error` of its polynomial. */
struct proof_place proof_place_on(const struct proof_piece *p,
                                  struct interval theta, double error,
                                  int side);

/* Where d and mu - tan(alpha) both have the sign of `side`: what is said above
 * holds there and outward. */
bool proof_is_outward(struct proof_law *p, const struct proof_place *at);

/* A bound on how far the settled coordinate still goes, outward, and on the
 * integral of |v - v_sp| over time out there. */
struct proof_tail {
    double way, excess;
};

/* v settles as psi runs to infinity (side 1) or to 0 or -infinity (side -1). */
bool proof_tail_psi(struct proof_law *p, const struct proof_place *at,
                    struct proof_tail *out);

/* psi settles as v runs to 0. */
bool proof_tail_v(struct proof_law *p, const struct law *law,
                  const struct proof_place *at, struct proof_tail *out);
