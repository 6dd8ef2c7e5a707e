/* The tube gives places near which the manifold passes, at any theta of any
 * cell.  Since the manifold rises, it meets a row beyond each such place that
 * is below it and before each that is above: a search along the branch for the
 * last and the first of them has to be good, not right. */
#include "proof_side.h"

#include <stdlib.h>

#include "interval_math.h"
#include "numbers.h"
#include "proof_end.h"
#include "proof_flow.h"

/* ---- places along a branch ----------------------------------------------- */

/* The cone, then the cells of the pieces that are proved. */
static size_t parts_of(const struct proof_branch *b)
{
    size_t cells = 0;

    for (size_t i = 0; i < b->pieces; i++)
        cells += b->piece[i].cells;
    return b->pieces > 0 ? 1 + cells : 0;
}

/* At t - floor(t) of part floor(t). */
static struct proof_place place_at(const struct proof_branch *b, double t)
{
    const size_t part = (size_t) t;
    const double way = t - (double) part;
    const struct proof_piece *p = b->piece;

    if (part == 0) {
        const double theta = way * b->cone.reach;
        return proof_place_on(p, interval_point(theta),
                              proof_up_times(b->cone.slope, theta), b->side);
    }
    const struct proof_cell *c = &b->cell[part - 1];
    while (part - 1 >= p->first + p->cells)
        p++;
    const double theta = c->from + way * (c->to - c->from);
    return proof_place_on(p, interval_point(theta < c->to ? theta : c->to),
                          c->radius, b->side);
}

/* ---- rows ---------------------------------------------------------------- */

static struct interval outward(const struct proof_branch *b, struct interval u)
{
    return b->side > 0 ? u : interval_minus(u);
}

/* |X| where the branch meets the row |Y|, which is outward of the saddle; both
 * ends infinite where it does not. */
static struct interval meet(const struct proof_branch *b, struct interval Y)
{
    const struct interval strip = outward(b, b->strip);
    struct interval out = { 0, HUGE_VAL };

    for (int beyond = 0; beyond < 2; beyond++) {
        double lo = 0, hi = (double) parts_of(b), t = hi / 2;
        for (; lo < t && t < hi; t = lo / 2 + hi / 2) {
            const struct proof_place at = place_at(b, t);
            const struct interval X = outward(b, at.X), y = outward(b, at.Y);
            const bool is_before = y.hi<Y.lo, is_beyond = y.lo> Y.hi;
            if (is_before)
                out.lo = fmaxl(out.lo, X.lo);
            if (is_beyond)
                out.hi = fminl(out.hi, X.hi);
            *(is_before || (!is_beyond && beyond) ? &lo : &hi) = t;
        }
    }
    if (b->end == (int) END_PSI_INF || b->end == (int) END_PSI_0)
        out.hi = fminl(out.hi, strip.hi);
    if (b->end == (int) END_V_0 && Y.lo > strip.hi)
        out.lo = HUGE_VAL;
    return out;
}

/* X where the manifold meets the row Y; -infinity where it does not, or where
 * that is not known; infinity likewise. */
static struct interval cross(const struct proof *p, struct interval Y)
{
    const struct proof_branch *upper = &p->branch[0], *lower = &p->branch[1];

    if (Y.lo > 0)
        return meet(upper, Y);
    if (Y.hi < 0)
        return interval_minus(meet(lower, interval_minus(Y)));
    return (struct interval){
        -meet(lower, (struct interval){ 0, fmaxl(0, -Y.lo) }).hi,
        meet(upper, (struct interval){ 0, fmaxl(0, Y.hi) }).hi
    };
}

/* Of n columns at X, ascending, those before and behind `at`. */
static struct proof_row cut(const struct interval X[], size_t n,
                            struct interval at)
{
    struct proof_row row = { .fast = n,
                             .beyond = isinf(at.lo) || isinf(at.hi) };

    while (row.slow < n && X[row.slow].hi < at.lo)
        row.slow++;
    while (row.fast > row.slow && X[row.fast - 1].lo > at.hi)
        row.fast--;
    return row;
}

enum status proof_rows(const struct proof *p, const double v[], size_t columns,
                       const double psi[], size_t rows, struct proof_row out[])
{
    struct interval *X = malloc((columns + 1) * sizeof *X);

    if (X == NULL)
        return STATUS_NO_MEMORY;
    for (size_t i = 0; i < columns; i++)
        X[i] = interval_less(interval_ln(interval_point(v[i])), p->law.x);
    for (size_t j = 0; j < rows; j++) {
        const struct interval at = interval_point(psi[j]);
        const struct interval y = p->law.is_log ? at : interval_ln(at);
        out[j] = cut(X, columns, cross(p, interval_less(y, p->law.y)));
    }
    free(X);
    return STATUS_OK;
}

/* mu_ss falls on one interval of v at most (docs/proofs.md, 14): there is a
 * node beyond it where friction at an end of the plane has a limit, as a ln v
 * then goes on. */
int proof_has_node(const struct law *law, const struct material *m, int side)
{
    const bool plain = law->theta == THETA_PSI;
    const bool ends = law->theta == THETA_LN_PSI || m->c <= 0;

    if (law->typed || law->psi_ss == PSI_SS_LAMBERT)
        return -1;
    if (law->psi_ss == PSI_SS_MINUS_LOG)
        return plain ? 0 : -1;
    return side > 0 ? plain || !ends : law->psi_ss != PSI_SS_INVERSE;
}
