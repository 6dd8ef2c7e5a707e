/* Steady states and the field from the law's formulas. */
#include "quad_block.h"

#include <assert.h>

#include "law_graph.h"
#include "law_tape.h"

#define FN(f)  f##q
#define SCALAR quad
#include "scalar.h"

static quad steady(const struct law *law, const struct material *m, quad x,
                   enum law_number what)
{
    struct law_quad p;

    law_quad_init(&p, law, m, 0);
    return law_quad_steady(&p, x, what);
}

quad quad_block_mu_ss(const struct law *law, const struct material *m, quad x)
{
    return steady(law, m, x, LAW_AT_MU);
}

quad quad_block_y_ss(const struct law *law, const struct material *m, quad x)
{
    return steady(law, m, x, LAW_AT_Y);
}

quad quad_block_equilibrium(const struct law *law, const struct material *m,
                            quad tan_alpha, quad lo, quad hi)
{
    const quad sign = quad_block_mu_ss(law, m, lo) < tan_alpha ? 1 : -1;

    for (quad mid = (lo + hi) / 2; lo < mid && mid < hi; mid = (lo + hi) / 2)
        if (sign * (quad_block_mu_ss(law, m, mid) - tan_alpha) < 0)
            lo = mid;
        else
            hi = mid;
    return lo;
}

void quad_block_anchor(const struct law *law, const struct material *m,
                       quad tan_alpha, quad x, bool equilibrium,
                       struct quad_anchor *at)
{
    struct formula_value leaf[LAW_VALUES];
    struct tape_lowered room;
    quad constant[FORMULA_NODES];

    at->x0 = x;
    at->y0 = quad_block_y_ss(law, m, x);
    at->v0 = expq(x);
    at->psi0 = steady(law, m, x, LAW_AT_PSI);
    at->mu0 = equilibrium ? tan_alpha : quad_block_mu_ss(law, m, x);
    at->force0 = tan_alpha - at->mu0;
    law_values(law, m, tan_alpha, x, at->y0, leaf);
    const struct tape_lowered *tape = law_tape_kept(law, equilibrium, &room);
    formula_constants(&tape->f, leaf, tape->t.needs, constant);
    const bool fits = quad_tape_at(&tape->t, constant, &at->tape);
    assert(fits); /* it is no longer than that of doubles */
    (void) fits;
}

void quad_block_field(const struct quad_anchor *at, quad X, quad Y,
                      struct quad_field *f)
{
    quad mu;

    quad_tape_field(&at->tape, X, Y, f->direction, &f->log_scale, &mu);
}

quad quad_block_mu(const struct quad_anchor *at, quad X, quad Y)
{
    quad rate[2], scale, mu;

    quad_tape_field(&at->tape, X, Y, rate, &scale, &mu);
    return mu;
}

quad quad_block_rate(const struct quad_anchor *at, enum block_observable which,
                     quad X, quad Y)
{
    switch (which) {
        case BLOCK_SLIP:
            return expq(at->x0 + X);
        case BLOCK_EXCESS:
            return scalar_expm1(at->v0, at->x0, X);
        default: /* BLOCK_WORK */
            return quad_block_mu(at, X, Y) * expq(at->x0 + X);
    }
}
