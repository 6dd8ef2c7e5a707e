/* A proof walks along a branch as it was grown, piece by piece: cone, cells,
 * and on to the next piece. */
#include "proof.h"

#include <stdio.h>
#include <stdlib.h>

#include "interval_tape.h"
#include "proof_cell.h"
#include "proof_end.h"
#include "proof_flow.h"
#include "proof_join.h"
#include "proof_knee.h"
#include "proof_short.h"
#include "proof_tolerance.h"
#include "proof_tube.h"

/* ---- candidates ---------------------------------------------------------- */

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

/* The piece begins where the last one ends, at theta, and its defect D = step G
 * - p' about its middle, whose integral is what p lacks but for terms of second
 * order, is added to it.  Neither is changed where D is not finite. */
static void proof_polish(struct interval_tape *t,
                         const struct proof_piece *last, struct interval theta,
                         struct proof_piece *p)
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

/* ---- a branch ------------------------------------------------------------ */

static void fail(struct proof_branch *out, const char *why)
{
    out->end = -1;
    out->not_proved = out->no_more = why;
}

/* The tail, outward: a coordinate goes on by 0 .. way. */
static void settle(struct proof_branch *out, enum end_code end,
                   struct interval from, const struct proof_tail *t,
                   const struct proof_front *f)
{
    const double more = proof_up_sum(t->way, 0);
    const struct interval way = out->side > 0 ? (struct interval){ 0, more }
                                              : (struct interval){ -more, 0 };
    const struct interval excess =
        out->side > 0 ? f->excess : interval_minus(f->excess);

    out->end = (int) end;
    out->beyond = t->slope;
    out->place = interval_add(from, way);
    out->strip = interval_hull(from, out->place);
    out->excess = interval_add(excess, (struct interval){ 0, t->excess });
}

/* At theta, the end of piece i, or why not; *left: what is beyond, over the
 * width of what is known.  Nothing wider than `most` is looked for. */
static const char *close(struct proof_law *law, struct proof_branch *out,
                         size_t i, struct interval theta, double most,
                         const struct proof_front *f, double *left)
{
    const struct proof_piece *p = &out->piece[i];
    const struct proof_place at = proof_place_on(p, theta, f->error, out->side);
    const bool psi = p->ind == 1;
    struct proof_tail t;

    const char *why = psi ? proof_tail_psi(law, &at, most, &t)
                          : proof_tail_v(law, &at, most, &t);
    if (why)
        return why;
    *left = fmax(t.way / f->error,
                 t.excess / (double) (f->excess.hi - f->excess.lo));
    settle(out,
           !psi            ? END_V_0
           : out->side > 0 ? END_PSI_INF
                           : END_PSI_0,
           psi ? at.X : at.Y, &t, f);
    return NULL;
}

/* The cells of one piece. */
static bool pass(struct proof_law *law, struct proof_branch *out, size_t i,
                 const struct proof_piece *next, struct interval to,
                 struct proof_front *f, enum status *status)
{
    struct proof_piece *p = &out->piece[i];
    const double from = i == 0 ? out->cone.reach : 0;

    p->first = out->cells;
    if (!proof_cells(&law->tape, p, from, to, f, out, status))
        return false;
    p->cells = out->cells - p->first;
    out->until = next && next->ind == p->ind ? next->start : HUGE_VAL;
    return true;
}

/* Known from the end of the cone on. */
static bool is_open(struct proof_law *law, const struct proof_branch *b,
                    const struct proof_front *f)
{
    const struct proof_place at =
        proof_place_on(&b->piece[0], point(b->cone.reach), f->error, b->side);

    return proof_tail_open(law, &at) == NULL;
}

/* On an open branch: beyond the offset Y = far, and no knee follows. */
static bool is_far(struct proof_law *law, struct proof_branch *out, size_t i,
                   struct interval theta, const struct proof_front *f,
                   double far)
{
    const struct proof_place at =
        proof_place_on(&out->piece[i], theta, f->error, out->side);

    out->beyond = proof_tail_steep(law, &at);
    return out->beyond && at.Y.lo > far;
}

/* From the end of the cone on, to where what is left is nothing beside what is
 * not known, to the last piece or through PROOF_CELLS cells, or on an open
 * branch as far as is_far(*far); the pieces beyond the end are let go. */
static enum status walk(struct proof_law *law, struct proof_branch *out,
                        struct proof_front *f, const double *far)
{
    enum status status = STATUS_OK;

    for (size_t i = 0; i < out->pieces; i++) {
        struct proof_piece *next =
            i + 1 < out->pieces ? &out->piece[i + 1] : NULL;
        const struct interval to = proof_piece_end(&out->piece[i], next);
        double left = HUGE_VAL;
        if (!pass(law, out, i, next, to, f, &status)) {
            fail(out, "no tube around the manifold was proved");
            return status;
        }
        if (far && is_far(law, out, i, to, f, *far))
            return STATUS_OK;
        const bool last = next == NULL || out->cells > PROOF_CELLS;
        const char *why =
            far ? NULL : close(law, out, i, to, last ? 1 : f->error, f, &left);
        if (far == NULL && why == NULL && (last || left < PROOF_END_PART)) {
            out->not_proved = NULL;
            out->pieces = i + 1;
            return STATUS_OK;
        }
        fail(out, why);
        if (last)
            return STATUS_OK;
        proof_polish(&law->tape, &out->piece[i], to, next);
        if (!proof_join(&law->tape, &out->piece[i], next, to, f)) {
            fail(out, "the tube was lost between two pieces");
            return STATUS_OK;
        }
    }
    return STATUS_OK;
}

static enum status prove_branch(struct proof_law *law,
                                const struct proof_inputs *in,
                                const struct branch *curve,
                                struct proof_branch *out)
{
    struct proof_front f = { 0 };
    enum status status = proof_pieces(curve, out);

    fail(out, "the manifold was not grown");
    if (status != STATUS_OK || out->pieces == 0)
        return status;
    if (!proof_cone(&law->tape, &out->piece[0], 1, &out->cone, &f)) {
        fail(out, "no cone around the manifold at the saddle was proved");
        return STATUS_OK;
    }
    const bool open = is_open(law, out, &f);
    const double far =
        in->far ? (law->is_log ? *in->far : log(*in->far)) - (double) law->y.lo
                : 0;
    status = walk(law, out, &f, open ? &far : NULL);
    if (open) {
        fail(out, NULL);
        out->end = END_OPEN;
    }
    proof_knees(&law->tape, out);
    return status;
}

/* ---- all ----------------------------------------------------------------- */

enum status proof_along(const struct block *b, const struct proof_inputs *in,
                        const struct branch curve[2], struct proof *out)
{
    static const struct branch none;
    struct fault why;
    enum status s = STATUS_OK;

    *out = (struct proof){ .branch = { { .side = 1, .end = -1 },
                                       { .side = -1, .end = -1 } } };
    s = proof_law_at(&out->law, b, in, &why);
    if (s == STATUS_BAD_ARGUMENT)
        out->not_proved = why;
    else if (s == STATUS_OK && !proof_is_saddle(&out->law.tape, &out->saddle))
        snprintf(out->not_proved.text, sizeof out->not_proved.text,
                 "the determinant of the Jacobian was not proved negative");
    for (int i = 0; i < 2 && s == STATUS_OK && !out->not_proved.text[0]; i++)
        s = prove_branch(&out->law, in, in->skip[i] ? &none : &curve[i],
                         &out->branch[i]);
    return s == STATUS_BAD_ARGUMENT ? STATUS_OK : s;
}

/* Curves as good as doubles allow, until nothing changes. */
static enum status grow(const struct block *b, struct branch curve[2])
{
    const struct planar sys = block_planar(b);
    struct grow_options o = grow_defaults(PROOF_RTOL);
    struct equilibrium e;
    struct local_series u;
    struct branch both[2];

    equilibrium_at(&sys, false, &e);
    o.reach = &sys.domain;
    o.carry = (struct carry){ { BLOCK_EXCESS }, 1 };
    enum status s =
        local_at(&sys, &e, MANIFOLD_STABLE, &o.carry, o.order, PROOF_TERM, &u);
    if (s == STATUS_OK)
        s = grow_branches(&sys, &u, &o, both);
    if (s != STATUS_OK)
        return s;
    const bool up = u.ind == 0 || u.c[1] > 0;
    curve[0] = both[up ? 0 : 1];
    curve[1] = both[up ? 1 : 0];
    return STATUS_OK;
}

enum status proof_at(const struct block *b, const struct proof_inputs *in,
                     struct proof *out)
{
    struct branch curve[2] = { { .curve = CURVE_EMPTY(2) },
                               { .curve = CURVE_EMPTY(2) } };
    const enum status grown =
        in->skip[0] && in->skip[1] ? STATUS_OK : grow(b, curve);

    *out = (struct proof){ 0 };
    const enum status s =
        grown == STATUS_NO_MEMORY ? grown : proof_along(b, in, curve, out);

    for (int i = 0; i < 2; i++)
        branch_free(&curve[i]);
    return s;
}

void proof_free(struct proof *p)
{
    proof_law_free(&p->law);
    for (int i = 0; i < 2; i++) {
        free(p->branch[i].piece);
        free(p->branch[i].cell);
        p->branch[i].piece = NULL;
        p->branch[i].cell = NULL;
    }
}
