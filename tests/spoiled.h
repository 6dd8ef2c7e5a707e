/* spoiled.h -- branches that are wrong on purpose. */
#pragma once

#include "branch.h"
#include "check.h"

/* Which coefficients of the dependent coordinate are multiplied: all but the
 * constants, those of theta, constants - of which the saddle's is 0 -, none. */
enum spoil { SPOIL_ALL, SPOIL_SLOPE, SPOIL_PLACE, SPOIL_NONE, SPOILS };

static inline void spoil(struct branch *b, enum spoil kind, double noise,
                         uint64_t *rng)
{
    static const size_t first[] = { 1, 1, 0, 1 }, last[] = { 99, 1, 0, 0 };

    for (size_t i = 0; i < b->curve.count; i++) {
        const struct curve_piece *p = &b->curve.piece[i];
        const size_t dep = (size_t) (1 - branch_graph(b, i));
        double *coef = b->curve.coef + p->first + dep * (p->degree + 1);
        for (size_t k = first[kind]; k <= p->degree && k <= last[kind]; k++)
            coef[k] *= 1 + noise * check_uniform(rng, -1, 1);
    }
}
