/*
 * proof.h -- the stable manifold of the saddle of a block on a slope, (17),
 * enclosed with proof: what is in a `proof` is a theorem about the inputs as
 * decimals, not an estimate.  docs/proofs.md has the theorems.
 *
 * Offsets (X, Y) are those of the chart (ln v, ln psi) [(ln v, psi)] from the
 * exact saddle, which lies in `saddle`.  A branch is enclosed by its tube
 * (proof_tube.h) and, beyond the last cell, by monotonicity (proof_end.h).
 */
#pragma once

#include "block.h"
#include "grow.h"
#include "numbers.h"
#include "proof_cone.h"
#include "proof_law.h"

struct proof {
    struct proof_law law; /* the place of the saddle, and the field around it */
    struct proof_saddle saddle;
    struct proof_branch branch[2]; /* upper, lower */
    struct fault not_proved;       /* of the saddle; empty: it is one */
};

/* Proves what can be proved of the block at its saddle, where b is anchored.
 * STATUS_NO_MEMORY; what cannot be proved says why.  proof_free either way. */
MUST_CHECK enum status proof_at(const struct block *b,
                                const struct proof_inputs *in,
                                struct proof *out);

/* The same along given curves, of any quality: upper and lower.  Anchored at a
 * saddle of sys = block_planar(b). */
MUST_CHECK enum status proof_along(const struct block *b,
                                   const struct proof_inputs *in,
                                   const struct branch curve[2],
                                   struct proof *out);

void proof_free(struct proof *p);
