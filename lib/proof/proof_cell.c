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

/* On the way back to the saddle theta falls. */
static bool falls(const struct cell *c, const struct proof_flow *f)
{
    return step_times(c, f->ind.c[0]).hi < 0;
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
    if (!falls(c, &c->all) || !falls(c, &c->centre))
        return false;
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

/* Whether cells shorter than this one, or than one of twice its length if that
 * multiplies remainders by `growth`, would have a smaller defect, or remainder
 * of the excess, that would be felt. */
static bool is_coarse(const struct cell *c, const struct proof_front *front,
                      double growth)
{
    const double rest = (c->defect - c->remainder) * c->half;
    const long double felt =
        front->error + LDBL_EPSILON * interval_most(c->dep[0]);
    const double made = c->remainder * growth * c->half;
    const long double known = front->excess.hi - front->excess.lo +
                              LDBL_EPSILON * interval_most(front->excess);

    return (made > PROOF_REMAINDER * rest && made > PROOF_FELT * felt) ||
           c->beside * growth > PROOF_FELT * known;
}

/* ---- the tube ------------------------------------------------------------ */

/* A part of the cell: of theta, its length, and what it found. */
struct part {
    struct interval theta, length;
    double rate;   /* step dG/d dep <= rate */
    double across; /* |d/d dep| of the excess per theta */
};

/* step (v - v_sp)/(-f_ind), the excess per theta, by dep: (e' - q f')/f. */
static bool bound_rate(const struct cell *c, double radius, struct part *t)
{
    const struct proof_piece *piece = c->piece;
    const struct interval dep = proof_poly_of(
        piece->degree, c->dep, interval_less(t->theta, c->middle));
    struct proof_flow f;

    proof_flow_aside(c->tape, piece->ind, ind_at(piece, t->theta),
                     interval_add(dep, interval_within(radius)), &f);
    if (!falls(c, &f))
        return false;
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

/* The error after the part, and the largest on it. */
static double grown(const struct part *t, double defect, double error,
                    double *most)
{
    const struct interval rise =
        interval_exp(interval_times(point(t->rate), t->length));
    const long double larger = t->rate > 0 ? rise.hi : 1;
    const double made =
        proof_up_times(proof_up_times(defect, t->length.hi), larger);

    *most = proof_up_times(
        proof_up_sum(error, proof_up_times(defect, t->length.hi)), larger);
    return proof_up_sum(proof_up_times(error, rise.hi), made);
}

/* Runs the parts one after another in a tube of the given radius. */
static bool run_tube(const struct cell *c, struct proof_cell *out,
                     double *across)
{
    double at = c->from, error = out->before; /* at theta = at */

    *across = 0;
    out->rate = -HUGE_VAL;
    for (int i = 1; i <= PROOF_PARTS; i++) {
        const double next = i == PROOF_PARTS
                                ? c->to
                                : c->from + (c->to - c->from) * i / PROOF_PARTS;
        struct part t = { .theta = { at, next } };
        double most;

        t.length =
            interval_less(next < c->last.hi ? point(next) : c->last, point(at));
        if (!(t.length.lo >= 0) || !bound_rate(c, out->radius, &t))
            return false;
        error = grown(&t, c->defect, error, &most);
        if (!(most <= out->radius && error <= out->radius))
            return false;
        *across = proof_up_sum(*across, proof_up_times(t.across, t.length.hi));
        out->rate = fmax(out->rate, t.rate);
        at = next;
    }
    out->after = error;
    return true;
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

/* In a tube twice as wide as error and defect are: *front moves on. */
static bool prove(struct cell *c, struct proof_front *front,
                  struct proof_cell *out)
{
    double across;

    *out = (struct proof_cell){ .from = c->from,
                                .to = c->to,
                                .before = front->error,
                                .defect = c->defect };
    out->radius = proof_up_sum(
        2 * proof_up_sum(front->error, proof_up_times(c->defect, 2 * c->half)),
        DBL_MIN);
    if (!run_tube(c, out, &across))
        return false;
    out->excess = interval_of_double(
        interval_outward(excess_of(c, proof_up_times(across, out->radius))));
    if (!interval_is_finite(out->excess))
        return false;
    front->error = out->after;
    front->excess = interval_add(front->excess, out->excess);
    return true;
}

static bool cells(struct cell *c, double from, double to, int depth,
                  struct proof_front *front, struct proof_branch *out,
                  enum status *status)
{
    struct proof_cell cell;

    c->from = from;
    c->to = to;
    const bool bounded = depth >= front->halvings && bound_defect(c);
    if (bounded && (!is_coarse(c, front, 1) || depth == PROOF_HALVINGS) &&
        prove(c, front, &cell)) {
        const double twice = ldexp(1, (int) c->piece->degree);
        front->halvings = depth - !is_coarse(c, front, twice);
        *status = keep(out, &cell);
        return *status == STATUS_OK;
    }
    const double half = from / 2 + to / 2;
    return depth < PROOF_HALVINGS && half > from && half < to &&
           cells(c, from, half, depth + 1, front, out, status) &&
           cells(c, half, to, depth + 1, front, out, status);
}

bool proof_cells(struct interval_tape *t, const struct proof_piece *piece,
                 double from, struct interval to, struct proof_front *front,
                 struct proof_branch *out, enum status *status)
{
    struct cell c = { .tape = t, .piece = piece, .last = to };

    return to.hi > from &&
           cells(&c, from, interval_up(to.hi), 0, front, out, status);
}
