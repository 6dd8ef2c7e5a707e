/*
 * proof_side.h -- on which side of the saddle's stable manifold states lie, and
 * what becomes of a side (docs/proofs.md, theorems 12 to 14): each row psi =
 * const is met at most once, the slow side is left of that point.
 */
#pragma once

#include "proof.h"

/* Of a row: the columns before `slow` are on the slow side, those from `fast`
 * on are on the fast side; between them the tube may be, or, `beyond`, it ends
 * before. */
struct proof_row {
    size_t slow, fast;
    bool beyond;
};

/* States of v and psi taken as these doubles, v > 0 ascending, psi > 0 where it
 * is no logarithm.  STATUS_NO_MEMORY. */
MUST_CHECK enum status proof_rows(const struct proof *p, const double v[],
                                  size_t columns, const double psi[],
                                  size_t rows, struct proof_row out[]);

/* Of a side - 1: fast, -1: slow - 1: all of it tends to a node that is there;
 * 0: its v tends to infinity, or 0; -1: neither is known.  A law of R = inf is
 * its limit (proof_law.h). */
int proof_has_node(const struct law *law, const struct material *m, int side);
