/*
 * variate.h -- what takes the jumps out of the probabilities of a push's fates
 * over scrambled draws.
 *
 * Let g(others) be about where the separatrix meets the line of the score z_j
 * through a draw's scores z (draws_scores): threshold.h, by the push's margins.
 * Whatever g is,
 *
 *     c = [z_j < g] - P(z_j < g | others)
 *
 * has mean 0, so that [fate is f] - b_f c has that of [fate is f].  With
 *
 *     b_f = P(f | z_j < g) - P(f | z_j >= g)
 *
 * jumps are left only where g errs, on a part P(g errs) of the draws, which is
 * small where the margin is smooth and monotone in z_j; the rest is as smooth
 * in the others as g, and scrambled points are even there (pre-integration:
 * Griewank, Kuo, Leovey & Sloan, J. Comput. Appl. Math. 344 (2018) 259-274;
 * here along a line of the fit, not of the margin, which costs no study).
 * Without a threshold b = 0.
 *
 * No draw is in its own fit: g and b of the even repeats are from the draws of
 * the odd ones and the other way round, so that nothing is biased.
 */
#pragma once

#include "draws.h"
#include "fate.h"
#include "spool.h"
#include "threshold.h"

/* What pushes may come to: fates, or attractors of a system; and last nothing
 * that has a name. */
enum { GOALS = 16 };
_Static_assert(GOALS >= (int) FATES, "each fate is a goal");

struct variate_half {
    struct threshold g;
    double slope[GOALS + 1]; /* b; the last: none */
};

struct variate {
    const struct draws *d;       /* borrowed */
    struct variate_half half[2]; /* for even repeats, for odd ones */
};

/* The goals of push k in a block, by its fate's code; or of a
 * system of[code of its reason], of NULL: a law's.  STATUS_IO. */
MUST_CHECK enum status variate_goals(const struct spool *s, size_t block,
                                     size_t k, const int8_t of[],
                                     int8_t goal[SPOOL_DRAWS],
                                     struct fault *why);

/* Of push k of a whole spool.  STATUS_IO, STATUS_NO_MEMORY. */
MUST_CHECK enum status variate_fit(struct variate *c, const struct spool *s,
                                   const struct draws *d, size_t k,
                                   const int8_t of[], struct fault *why);

/* b_f c of draw i, by f. */
void variate_at(const struct variate *c, size_t i, double out[GOALS + 1]);
