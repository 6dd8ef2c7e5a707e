/* Steady states from steady_formula.h, the field from the law's formulas. */
#include "quad_block.h"

#include <assert.h>

#include "law_tape.h"
#include "law_typed.h"

#define T       quad
#define NAME(f) quad_##f
#define FN(f)   f##q
#define REAL(f) scalar_##f
#define SCALAR  quad
#include "scalar.h"
#include "steady_formula.h"

quad quad_block_mu_ss(const struct law *law, const struct material *m, quad x)
{
    return law->typed ? law_typed_steady_quad(law, m, x).mu
                      : quad_mu_ss(law, m, x);
}

quad quad_block_y_ss(const struct law *law, const struct material *m, quad x)
{
    return law->typed ? law_typed_steady_quad(law, m, x).y
                      : quad_y_ss(law, m, x);
}

/* What steady states are found by. */
static quad mu_log(const struct law *law, const struct material *m, quad x)
{
    return law->typed ? quad_block_mu_ss(law, m, x) : quad_mu_log_ss(law, m, x);
}

quad quad_block_equilibrium(const struct law *law, const struct material *m,
                            quad tan_alpha, quad lo, quad hi)
{
    const quad tau = law->typed ? tan_alpha : quad_tau(law, m, tan_alpha);
    const bool rises = mu_log(law, m, lo) < tau;

    for (quad mid = (lo + hi) / 2; lo < mid && mid < hi; mid = (lo + hi) / 2)
        if ((mu_log(law, m, mid) < tau) == rises)
            lo = mid;
        else
            hi = mid;
    return lo;
}

/* Of a law of formulas: what its tape does not hold. */
static void typed_anchor(const struct law *law, const struct material *m,
                         quad tan_alpha, quad x, bool equilibrium,
                         struct quad_anchor *at)
{
    const struct typed_steady_quad s = law_typed_steady_quad(law, m, x);

    at->x0 = x;
    at->y0 = s.y;
    at->v0 = expq(x);
    at->psi0 = s.psi;
    at->mu0 = equilibrium ? tan_alpha : s.mu;
    at->force0 = tan_alpha - at->mu0;
    at->log_inertia =
        -logq(quad_eps2(m)) - log1pq(tan_alpha * tan_alpha) / 2 - x;
}

void quad_block_anchor(const struct law *law, const struct material *m,
                       quad tan_alpha, quad x, bool equilibrium,
                       struct quad_anchor *at)
{
    struct formula_value leaf[LAW_VALUES];
    struct tape_lowered room;
    quad constant[FORMULA_NODES];

    if (law->typed)
        typed_anchor(law, m, tan_alpha, x, equilibrium, at);
    else
        quad_anchor(law, m, tan_alpha, x, equilibrium, at);
    law_values(law, m, tan_alpha, x, at->y0, leaf);
    const struct tape_lowered *tape = law_tape_kept(law, equilibrium, &room);
    formula_constants(&tape->f, leaf, tape->t.needs, 0, constant);
    const bool fits = quad_tape_at(&tape->t, constant, &at->tape);
    assert(fits); /* it is no longer than that of doubles */
    (void) fits;
}

void quad_block_field(const struct law *law, const struct quad_anchor *at,
                      quad X, quad Y, struct quad_field *f)
{
    quad mu;

    (void) law; /* at knows it */
    quad_tape_field(&at->tape, X, Y, f->direction, &f->log_scale, &mu);
}

quad quad_block_mu(const struct law *law, const struct quad_anchor *at, quad X,
                   quad Y)
{
    quad rate[2], scale, mu;

    (void) law;
    quad_tape_field(&at->tape, X, Y, rate, &scale, &mu);
    return mu;
}

quad quad_block_rate(const struct law *law, const struct quad_anchor *at,
                     enum block_observable which, quad X, quad Y)
{
    switch (which) {
        case BLOCK_SLIP:
            return expq(at->x0 + X);
        case BLOCK_EXCESS:
            return scalar_expm1(at->v0, at->x0, X);
        default: /* BLOCK_WORK */
            return quad_block_mu(law, at, X, Y) * expq(at->x0 + X);
    }
}
