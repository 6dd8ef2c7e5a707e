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

struct variate_half {
    struct threshold g;
    double slope[FATES + 1]; /* b; the last: no fate */
};

struct variate {
    const struct draws *d;       /* borrowed */
    struct variate_half half[2]; /* for even repeats, for odd ones */
};

/* Of push k of a whole spool.  STATUS_IO, STATUS_NO_MEMORY. */
MUST_CHECK enum status variate_fit(struct variate *c, const struct spool *s,
                                   const struct draws *d, size_t k,
                                   struct fault *why);

/* b_f c of draw i, by f. */
void variate_at(const struct variate *c, size_t i, double out[FATES + 1]);
