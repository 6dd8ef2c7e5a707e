/*
 * proof_join.h -- a branch as it was grown, piece by piece, and from one piece
 * to the next: over the gap that rounding leaves between them, or round the
 * corner where the other coordinate becomes the independent one.
 */
#pragma once

#include "branch.h"
#include "interval_tape.h"
#include "proof_tube.h"

/* Pieces of a curve; out has none.  STATUS_NO_MEMORY. */
MUST_CHECK enum status proof_pieces(const struct branch *b,
                                    struct proof_branch *out);

/* The theta at which a piece ends: where the next one of its kind begins. */
struct interval proof_piece_end(const struct proof_piece *p,
                                const struct proof_piece *next);

/* A place on a branch, and on which side of the saddle it is. */
struct proof_place {
    struct interval X, Y;
    int side;
};

/* On a piece, within `error` of its polynomial. */
struct proof_place proof_place_on(const struct proof_piece *p,
                                  struct interval theta, double error,
                                  int side);

/* Where the branch has dep in `target`, ind is within *way of where it is at
 * theta: dep = p(theta) +- f->error there, and with |d dep/d ind| >= m > 0 on
 * the box of all places on the way dep comes to any number between after
 * |change of dep|/m < *way.  The integral on the way is added. */
bool proof_reach(struct interval_tape *t, const struct proof_piece *p,
                 struct interval theta, struct interval target,
                 struct proof_front *f, double *way);

/* On from theta, the end of p, to the beginning of the next piece. */
bool proof_join(struct interval_tape *t, const struct proof_piece *p,
                const struct proof_piece *next, struct interval theta,
                struct proof_front *f);
