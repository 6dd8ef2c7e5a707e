/*
 * proof_cell.h -- the tube: how far the stable manifold is from a polynomial on
 * a part of a piece, by Gronwall's inequality.
 *
 * Along ind = start + step theta the manifold satisfies
 *     d dep/d theta = step G,   G = f_dep/f_ind,
 * and w = dep - p(theta) satisfies w' = D + l w with D = step G(p) - p' and
 * l = step dG/d dep somewhere between.  With |D| <= defect on the cell, l <=
 * rate on every part of it and |dep - p| <= radius,
 *     |w(t)| <= e^(rate t) |w(0)| + defect t max(1, e^(rate t)),
 * which is compared with the radius on the whole part: if it is smaller, it
 * holds.
 */
#pragma once

#include "interval_tape.h"
#include "proof_tube.h"
#include "status.h"

/* From theta = from to theta = to, anywhere in the thin interval `to`; the
 * cells are appended to out.  False where no cell short enough is proved;
 * STATUS_NO_MEMORY in *status. */
bool proof_cells(struct interval_tape *t, const struct proof_piece *piece,
                 double from, struct interval to, struct proof_front *front,
                 struct proof_branch *out, enum status *status);
