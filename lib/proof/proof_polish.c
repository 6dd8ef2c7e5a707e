#include "proof_polish.h"

#include "proof_flow.h"
#include "proof_short.h"

/* Where the last one ends. */
static void begin(const struct proof_piece *last, struct interval theta,
                  struct proof_piece *p)
{
    const double ind = interval_middle(
        add(point(last->start), times(point(last->step), theta)));
    const double dep =
        interval_middle(proof_poly_at(last->degree, last->coef, theta));

    if (p->ind == last->ind) {
        p->coef[0] = dep;
    } else {
        p->start = dep;
        p->coef[0] = ind;
    }
}

/* step G - p' at order k about the middle. */
static void find_defect(struct interval_tape *t, const struct proof_piece *p,
                        struct interval off[])
{
    const size_t n = p->degree;
    const struct interval step = point(p->step), half = point(0.5);
    struct interval dep[JET_SIZE], g[JET_SIZE];
    struct proof_flow f;

    proof_points(n, p->coef, dep);
    proof_shift(n, dep, half, dep);
    proof_flow_along(t, p->ind, add(point(p->start), times(step, half)),
                     p->step, dep, n, &f);
    proof_quotient(n, f.dep.c, f.ind.c, g);
    for (size_t k = 0; k < n; k++)
        off[k] = interval_less(times(step, g[k]),
                               times(point((double) (k + 1)), dep[k + 1]));
}

void proof_polish(struct interval_tape *t, const struct proof_piece *last,
                  struct interval theta, struct proof_piece *p)
{
    const size_t n = p->degree;
    struct interval off[JET_SIZE], lacks[JET_SIZE] = { { 0, 0 } };

    begin(last, theta, p);
    find_defect(t, p, off);
    for (size_t k = 0; k < n; k++) {
        lacks[k + 1] = interval_divide(off[k], point((double) (k + 1)));
        if (!interval_is_finite(lacks[k + 1]))
            return;
    }
    proof_shift(n, lacks, point(-0.5), lacks);
    for (size_t k = 1; k <= n; k++)
        p->coef[k] = interval_middle(add(point(p->coef[k]), lacks[k]));
}
