#include "proof_join.h"

#include <stdlib.h>
#include <string.h>

#include "proof_flow.h"
#include "proof_short.h"
#include "proof_tolerance.h"

/* ---- pieces -------------------------------------------------------------- */

static struct proof_piece piece_of(const struct branch *b, size_t i)
{
    const int ind = branch_graph(b, i);
    const double *at = curve_component(&b->curve, i, (size_t) ind);
    const double *dep = curve_component(&b->curve, i, (size_t) (1 - ind));
    struct proof_piece p = { .ind = ind, .start = at[0], .step = at[1] };

    p.degree = b->curve.piece[i].degree;
    memcpy(p.coef, dep, (p.degree + 1) * sizeof *dep);
    return p;
}

enum status proof_pieces(const struct branch *b, struct proof_branch *out)
{
    out->piece = malloc((b->curve.count + 1) * sizeof *out->piece);
    if (out->piece == NULL)
        return STATUS_NO_MEMORY;
    for (; out->pieces < b->curve.count; out->pieces++)
        out->piece[out->pieces] = piece_of(b, out->pieces);
    return STATUS_OK;
}

struct interval proof_piece_end(const struct proof_piece *p,
                                const struct proof_piece *next)
{
    if (next == NULL || next->ind != p->ind)
        return point(1);
    return interval_divide(interval_less(point(next->start), point(p->start)),
                           point(p->step));
}

struct proof_place proof_place_on(const struct proof_piece *p,
                                  struct interval theta, double error, int side)
{
    const struct interval at =
        add(point(p->start), times(point(p->step), theta));
    const struct interval dep =
        add(proof_poly_at(p->degree, p->coef, theta), interval_within(error));

    return p->ind == 0 ? (struct proof_place){ at, dep, side }
                       : (struct proof_place){ dep, at, side };
}

/* ---- from one to the next ------------------------------------------------ */

static long double most_apart(struct interval u, double x)
{
    return interval_most(interval_less(u, point(x)));
}

bool proof_reach(struct interval_tape *t, const struct proof_piece *p,
                 struct interval theta, struct interval target,
                 struct proof_front *f, double *way)
{
    const struct interval at =
        add(point(p->start), times(point(p->step), theta));
    const struct interval from = add(proof_poly_at(p->degree, p->coef, theta),
                                     interval_within(f->error));
    const struct interval dep = interval_hull(from, target);
    const long double gap = interval_most(interval_less(target, from));
    struct proof_flow u;

    *way = 0;
    for (int i = 0; i < PROOF_TURN_TRIES; i++) {
        proof_flow_aside(t, p->ind, add(at, interval_within(*way)), dep, &u);
        const struct interval slope = interval_divide(u.dep.c[0], u.ind.c[0]);
        const double found = interval_up(
            interval_divide(point(gap), point(interval_least(slope))).hi);
        if (found < *way) {
            const struct interval per =
                interval_divide(u.excess.c[0], u.ind.c[0]);
            const double more = proof_up_times(interval_most(per), found);
            f->excess = add(f->excess, interval_within(more));
            *way = found;
            return isfinite(more);
        }
        *way = 2 * found + PROOF_END_LEAST;
    }
    return false;
}

bool proof_join(struct interval_tape *t, const struct proof_piece *p,
                const struct proof_piece *next, struct interval theta,
                struct proof_front *f)
{
    double way;

    if (next->ind == p->ind) {
        const struct interval dep = proof_poly_at(p->degree, p->coef, theta);
        f->error = proof_up_sum(f->error, most_apart(dep, next->coef[0]));
        return true;
    }
    if (!proof_reach(t, p, theta, point(next->start), f, &way))
        return false;
    const struct interval at =
        add(point(p->start), times(point(p->step), theta));
    f->error = proof_up_sum(way, most_apart(at, next->coef[0]));
    return true;
}
