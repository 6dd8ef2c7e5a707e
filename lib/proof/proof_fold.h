/*
 * proof_fold.h -- that a law of named components has no saddle at a slope:
 * mu_ss falls on one interval of v at most (docs/proofs.md, 14), and does not
 * pass tan(alpha) there.
 */
#pragma once

#include "law.h"
#include "proof_input.h"

/* True: proved; else it was not. */
bool proof_no_saddle(const struct law *law, const struct material *m,
                     const struct proof_inputs *in);
