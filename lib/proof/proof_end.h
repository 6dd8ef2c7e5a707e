/*
 * proof_end.h -- what is left of a branch beyond its last cell: theorems 6 to 8
 * of docs/proofs.md, whose inequalities are verified on the law's formulas over
 * strips of the plane that have no end (interval_growth.h).  Offsets X, Y.
 */
#pragma once

#include "proof_join.h"
#include "proof_law.h"

/* A bound on how far the settled coordinate still goes, outward, and on the
 * integral of |v - v_sp| over time out there; the sign of dy/dx - 1 there, 0
 * where it is not proved. */
struct proof_tail {
    double way, excess;
    int slope;
};

/* Each returns NULL or which inequality is not proved; nothing wider than
 * `most` is looked for. */

/* v settles as psi runs to infinity (side 1) or to 0 or -infinity (side -1). */
const char *proof_tail_psi(struct proof_law *p, const struct proof_place *at,
                           double most, struct proof_tail *out);

/* psi settles as v runs to 0. */
const char *proof_tail_v(struct proof_law *p, const struct proof_place *at,
                         double most, struct proof_tail *out);

/* v has no limit; NULL only where the strip beyond, to larger v and psi, has no
 * equilibrium: on the upper branch. */
const char *proof_tail_open(struct proof_law *p, const struct proof_place *at);

/* Whether dy/dx > 1 from there on, whatever the end; only there, too. */
bool proof_tail_steep(struct proof_law *p, const struct proof_place *at);
