/*
 * proof_knee.h -- the knees of a branch, docs/proofs.md, theorem 16: where
 * dy/dx rises through 1, going outward.
 *
 * On each part of the cone and of the tube either dy/dx - 1 has a sign, or its
 * derivative along the manifold has: between two signs that differ there is one
 * crossing then, between two equal ones none.
 */
#pragma once

#include "interval_tape.h"
#include "proof_tube.h"

/* Into b->knee, b->knees and b->no_more, outward as far as signs are proved. */
void proof_knees(struct interval_tape *tape, struct proof_branch *b);
