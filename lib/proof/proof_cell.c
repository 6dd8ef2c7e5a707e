#include "proof_cell.h"

#include <float.h>
#include <stdlib.h>

#include "proof_flow.h"
#include "proof_short.h"
#include "proof_tolerance.h"

struct cell {
    struct interval_tape *tape;
    const struct proof_piece *piece;
    double from, to, half;       /* half: at least half its length */
    struct interval last;        /* where the last one ends, at its upper end */
    struct interval middle, box; /* of theta */
    struct interval dep[JET_SIZE];   /* about the middle */
    struct interval over;            /* p over the cell */
    struct proof_flow centre, all;   /* at the middle, over the cell */
    struct interval slope[JET_SIZE]; /* step G at the middle; then of all */
    double defect, remainder;
    double beside; /* what Lagrange's remainder adds to the excess */
};

static struct interval ind_at(const struct proof_piece *piece,
                              struct interval theta)
{
    return interval_add(point(piece->start),
                        interval_times(point(piece->step), theta));
}

static struct interval step_times(const struct cell *c, struct interval u)
{
    return interval_times(point(c->piece->step), u);
}

/* ---- the defect ---------------------------------------------------------- */

static void expand(struct cell *c)
{
    const size_t n = c->piece->degree;
    struct interval wide[JET_SIZE];

    c->middle = point(c->from / 2 + c->to / 2);
    c->box = (struct interval){ c->from, c->to };
    const struct interval t = interval_less(c->box, c->middle);
    c->half = interval_up(interval_most(t));
    proof_points(n, c->piece->coef, wide);
    proof_shift(n, wide, c->middle, c->dep);
    proof_shift(n, c->dep, interval_within(c->half), wide);
    c->over = wide[0];
    proof_flow_along(c->tape, c->piece->ind, ind_at(c->piece, c->middle),
                     c->piece->step, c->dep, n, &c->centre);
    proof_flow_along(c->tape, c->piece->ind, ind_at(c->piece, c->box),
                     c->piece->step, wide, n, &c->all);
}

/* |D| <= sum_{k<n} |step G_k - (k + 1) p_{k+1}| h^k + |step G_n(cell)| h^n:
 * p has no term of order n + 1. */
static bool bound_defect(struct cell *c)
{
    const size_t n = c->piece->degree;
    struct interval g[JET_SIZE], off[JET_SIZE];

    expand(c);
    proof_quotient(n, c->centre.dep.c, c->centre.ind.c, g);
    for (size_t k = 0; k < n; k++)
        off[k] = interval_less(
            step_times(c, g[k]),
            interval_times(point((double) (k + 1)), c->dep[k + 1]));
    proof_quotient(n, c->all.dep.c, c->all.ind.c, g);
    off[n] = step_times(c, g[n]);
    c->remainder = proof_size(off, n, n, c->half);
    c->defect = proof_up_sum(proof_size(off, 0, n - 1, c->half), c->remainder);
    proof_quotient(n, c->all.excess.c, c->all.ind.c, g);
    g[n] = step_times(c, g[n]);
    c->beside = proof_up_times(proof_size(g, n, n, c->half),
                               interval_less(point(c->to), point(c->from)).hi);
    return isfinite(c->defect) && isfinite(c->beside);
}

/* What remainders add to the error, or to the integral, over what of it may be
 * felt: where that is above 1 a shorter cell would be better. */
static double coarseness(const struct cell *c, const struct proof_front *front)
{
    const long double error =
        front->error + LDBL_EPSILON * interval_most(c->dep[0]) + DBL_MIN;
    const long double known = front->excess.hi - front->excess.lo +
                              LDBL_EPSILON * interval_most(front->excess) +
                              DBL_MIN;

    return (double) fmaxl(c->remainder * c->half / error, c->beside / known) /
           PROOF_FELT;
}

/* ---- the tube ------------------------------------------------------------ */

/* What holds in the tube. */
struct tube {
    double rate;   /* step dG/d dep <= rate */
    double across; /* |d/d dep| of the excess per theta */
};

/* step (v - v_sp)/(-f_ind), the excess per theta, by dep: (e' - q f')/f. */
static bool bound_rate(const struct cell *c, double radius, struct tube *t)
{
    const struct proof_piece *piece = c->piece;
    struct proof_flow f;

    proof_flow_aside(c->tape, piece->ind, ind_at(piece, c->box),
                     interval_add(c->over, interval_within(radius)), &f);
    const struct interval g = interval_divide(f.dep.c[0], f.ind.c[0]);
    const struct interval q = interval_divide(f.excess.c[0], f.ind.c[0]);
    const struct interval dg = interval_divide(
        interval_less(f.dep.c[1], interval_times(g, f.ind.c[1])), f.ind.c[0]);
    const struct interval dq = interval_divide(
        interval_less(f.excess.c[1], interval_times(q, f.ind.c[1])),
        f.ind.c[0]);
    t->rate = interval_up(step_times(c, dg).hi);
    t->across = interval_up(interval_most(step_times(c, dq)));
    return isfinite(t->rate) && isfinite(t->across);
}

/* With r = e^(rate length), |dep - p| <= max(1, r) (before + defect length) as
 * long as that is within the radius, which is twice that sum: it is, if r <= 2.
 * *aside: what the tube adds to the excess. */
static bool run_tube(const struct cell *c, struct proof_cell *out,
                     double *aside)
{
    const struct interval ends = { fminl(c->to, c->last.lo), c->to };
    const struct interval length = interval_less(ends, point(c->from));
    struct tube t;

    if (!(length.lo >= 0) || !bound_rate(c, out->radius, &t))
        return false;
    const struct interval rise =
        interval_exp(interval_times(point(t.rate), length));
    const double made = proof_up_times(c->defect, length.hi);

    out->rate = t.rate;
    out->after = proof_up_sum(proof_up_times(out->before, rise.hi),
                              proof_up_times(made, t.rate > 0 ? rise.hi : 1));
    *aside = proof_up_times(proof_up_times(t.across, length.hi), out->radius);
    return rise.hi <= 2;
}

/* ---- the integral -------------------------------------------------------- */

/* The integral of step (v - v_sp)/(-f_ind): even orders about the middle, the
 * remainder, what the middle is beside half way, and what the tube adds. */
static struct interval excess_of(const struct cell *c, double aside)
{
    const size_t n = c->piece->degree;
    const struct interval a = interval_less(point(c->from), c->middle);
    const struct interval b =
        interval_less(c->to < c->last.hi ? point(c->to) : c->last, c->middle);
    struct interval q[JET_SIZE], sum = { 0, 0 };
    struct interval pa = a, pb = b;

    proof_quotient(n, c->centre.excess.c, c->centre.ind.c, q);
    for (size_t k = 0; k < n; k++) {
        const struct interval piece =
            interval_divide(interval_less(pb, pa), point((double) (k + 1)));
        sum = interval_add(sum, interval_times(q[k], piece));
        pa = interval_times(pa, a);
        pb = interval_times(pb, b);
    }
    sum = interval_times(point(-c->piece->step), sum);
    sum = interval_add(sum, interval_within(c->beside));
    return interval_add(sum, interval_within(aside));
}

/* ---- all ----------------------------------------------------------------- */

static enum status keep(struct proof_branch *out, const struct proof_cell *cell)
{
    if ((out->cells & (out->cells - 1)) == 0) {
        const size_t room = out->cells ? 2 * out->cells : 1;
        void *more = realloc(out->cell, room * sizeof *out->cell);
        if (more == NULL)
            return STATUS_NO_MEMORY;
        out->cell = more;
    }
    out->cell[out->cells++] = *cell;
    return STATUS_OK;
}

/* In a tube twice as wide as what error and defect come to: *front moves on. */
static bool prove(struct cell *c, struct proof_front *front,
                  struct proof_cell *out)
{
    double aside;

    *out = (struct proof_cell){ .from = c->from,
                                .to = c->to,
                                .before = front->error,
                                .defect = c->defect };
    out->radius = proof_up_sum(
        2 * proof_up_sum(front->error, proof_up_times(c->defect, 2 * c->half)),
        DBL_MIN);
    if (!run_tube(c, out, &aside))
        return false;
    out->excess = interval_of_double(interval_outward(excess_of(c, aside)));
    if (!interval_is_finite(out->excess))
        return false;
    front->error = out->after;
    front->excess = interval_add(front->excess, out->excess);
    return true;
}

/* Whether the integral is near the largest of doubles, so that only ever
 * shorter cells bound it. */
static bool is_endless(const struct cell *c)
{
    return isfinite(c->defect) && !isfinite(c->beside);
}

/* What the next cell, or this one again, is to have of theta: remainders grow
 * with the power n + 1 of it. */
static double fitting(const struct cell *c, double coarse)
{
    const double power = 1 / ((double) c->piece->degree + 1);

    return fmin(PROOF_CELL_MOST,
                (c->to - c->from) * fmax(0.5, pow(coarse / PROOF_AIM, -power)));
}

/* Cells of one size to the end, at most `length`: where the first one ends. */
static double next_end(double from, double end, double length)
{
    const double parts = ceil((end - from) / length);

    return parts > 1 ? from + (end - from) / parts : end;
}

bool proof_cells(struct interval_tape *t, const struct proof_piece *piece,
                 double from, struct interval to, struct proof_front *front,
                 struct proof_branch *out, enum status *status)
{
    const double end = interval_up(to.hi);
    struct cell c = { .tape = t, .piece = piece, .from = from, .last = to };
    double length = front->length > 0 ? front->length : PROOF_CELL_MOST;
    struct proof_cell cell;

    while (c.from < end && *status == STATUS_OK) {
        c.to = next_end(c.from, end, length);
        const double size = c.to - c.from;
        const bool least = size <= PROOF_CELL_LEAST;
        const double coarse =
            bound_defect(&c) ? coarseness(&c, front) : HUGE_VAL;
        const bool fine = coarse <= (least ? DBL_MAX : 1);
        length = fitting(&c, coarse);
        if (fine && prove(&c, front, &cell)) {
            *status = keep(out, &cell);
            c.from = c.to;
        } else if (least || is_endless(&c)) {
            return false;
        } else if (fine) {
            length = size / 2;
        }
    }
    front->length = length;
    return to.hi > from && *status == STATUS_OK;
}
