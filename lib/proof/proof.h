/*
 * proof.h -- the stable manifold of the saddle of a block on a slope, (17),
 * enclosed with proof: what is in a `proof` is a theorem about the inputs as
 * decimals, not an estimate.  docs/proofs.md has the theorems.
 *
 * Offsets (X, Y) are those of the chart (ln v, ln psi) [(ln v, psi)] from the
 * exact saddle, which lies in `saddle`.  A branch is enclosed in three parts:
 *
 *   cone   on pieces[0], 0 < theta <= cone.reach:
 *              |dep - p(theta)| <= cone.slope theta;
 *   tube   on every cell (from <= theta <= to of a piece):
 *              |dep - p(theta)| <= radius;
 *   end    beyond the last cell, by monotonicity (proof_end.h).
 *
 * where p = sum coef[k] theta^k is the dependent offset, the independent one is
 * start + step theta, start and step doubles taken exactly.
 */
#pragma once

#include "block.h"
#include "grow.h"
#include "proof_law.h"

/* A polynomial of the curve that is proved to be near. */
struct proof_piece {
    int ind;            /* 0: y(x); 1: x(y) */
    double start, step; /* ind offset = start + step theta */
    size_t degree;
    double coef[JET_SIZE]; /* dep offset = sum coef[k] theta^k */
    size_t first, cells;   /* its cells, in order and without gaps; the first
                              piece's begin at the end of the cone */
};

/* What Gronwall's inequality needs and gives on a part of a piece:
 *     |D| <= defect,  d(step G)/d dep <= rate,  G = f_dep/f_ind,
 *     |dep - p| <= before at `from`, <= after at `to`, <= radius between. */
struct proof_cell {
    double from, to; /* theta */
    double defect, rate;
    double before, after, radius;
    struct interval excess; /* integral of v - v_sp over time on it, inward */
};

struct proof_cone {
    double reach, slope; /* theta; |dep - p| <= slope theta */
    struct interval excess;
};

/* place: the offset that settles - X where psi runs to its end, Y where v does;
 * strip: where it is from the last cell on. */
struct proof_branch {
    int side; /* 1: upper, v > v_sp; -1: lower */
    struct proof_cone cone;
    struct proof_piece *piece; /* owned */
    size_t pieces;
    struct proof_cell *cell; /* owned */
    size_t cells;
    int end; /* enum end_code of numbers.h; -1: not_proved says why */
    struct interval place, strip;
    struct interval excess; /* integral of |v - v_sp| dt, where `end` is not
                               open */
    const char *not_proved; /* static; NULL: all of it is */
};

/* Eigenvalues per t*. */
struct proof_saddle {
    struct interval lambda_minus, lambda_plus;
};

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
