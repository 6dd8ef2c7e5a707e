/* Cone, tube and joins are those of a block's proof; what is new is whereto a
 * branch is followed: to a line, or until a cell ends in a trap. */
#include "proof_plane.h"

#include <string.h>

#include "proof_cell.h"
#include "proof_cone.h"
#include "proof_short.h"
#include "proof_tolerance.h"

/* ---- the field ----------------------------------------------------------- */

static void enclose(mpfi_ptr out, const struct system_number *n)
{
    mpfi_t bar;

    mpfi_init2(bar, PROOF_BITS);
    mpfi_interv_d(bar, -n->error, n->error);
    interval_graph_decimal(out, n->value);
    mpfi_add(out, out, bar);
    mpfi_clear(bar);
}

struct interval proof_plane_number(const struct system_number *n)
{
    mpfi_t u;

    mpfi_init2(u, PROOF_BITS);
    enclose(u, n);
    const struct interval out = interval_of_mpfi(u);
    mpfi_clear(u);
    return out;
}

static const char *leaf_of(const struct tape_lowered *l, int node)
{
    return l->f.node[node].name;
}

static void set_leaves(struct proof_plane *p, const struct tape_lowered *l,
                       const struct formula_value value[],
                       const struct system_number saddle[2])
{
    mpfi_t u;

    mpfi_init2(u, PROOF_BITS);
    for (; value->name; value++) {
        interval_graph_decimal(u, value->value);
        interval_graph_set(&p->at, value->name, u);
    }
    for (int i = 0; i < 2; i++) {
        enclose(u, &saddle[i]);
        interval_graph_set(&p->at, leaf_of(l, l->p.chart[i]), u);
    }
    mpfi_clear(u);
}

enum status proof_plane_at(struct proof_plane *p, const struct tape_lowered *l,
                           const struct formula_value value[],
                           const struct system_number saddle[2],
                           struct fault *why)
{
    bool needed[FORMULA_NODES];

    *p = (struct proof_plane){ .at = { .f = NULL } };
    memcpy(needed, l->t.needs, sizeof needed);
    enum status s = interval_graph_init(&p->at, &l->f, needed, PROOF_BITS);
    if (s != STATUS_OK)
        return s;
    set_leaves(p, l, value, saddle);
    s = interval_graph_run(&p->at, why);
    return s == STATUS_OK ? interval_tape_init(&p->tape, &l->t, &p->at, NULL, 0)
                          : s;
}

void proof_plane_free(struct proof_plane *p)
{
    interval_tape_free(&p->tape);
    interval_graph_free(&p->at);
}

/* ---- a branch ------------------------------------------------------------ */

struct walk {
    struct interval_tape *tape;
    struct proof_goal goal;
    struct proof_branch *out;
    struct proof_front front;
    enum status status;
};

/* Up to where the line is: theta there, or near. */
static struct interval theta_of(const struct proof_piece *p,
                                const struct proof_goal *g)
{
    if (p->ind != g->axis)
        return point(g->theta);
    return interval_divide(interval_less(g->at, point(p->start)),
                           point(p->step));
}

static bool cross(struct walk *w, const struct proof_piece *p,
                  struct interval theta, struct interval crossing[2])
{
    const int axis = w->goal.axis;
    double way = 0;

    if (p->ind != axis &&
        !proof_reach(w->tape, p, theta, w->goal.at, &w->front, &way))
        return false;
    const struct proof_place at = proof_place_on(p, theta, w->front.error, 0);
    const struct interval other =
        add(axis == 0 ? at.Y : at.X, interval_within(way));

    crossing[axis] = w->goal.at;
    crossing[1 - axis] = other;
    return interval_is_finite(other);
}

static bool is_trapped(const struct walk *w, const struct proof_piece *p,
                       double theta, double error)
{
    const struct proof_place at = proof_place_on(p, point(theta), error, 0);

    return proof_trap_holds(w->goal.trap, (struct interval[]){ at.X, at.Y });
}

/* Whether a cell of piece i ends in the trap: those beyond are let go. */
static bool comes_in(struct walk *w, size_t i)
{
    struct proof_piece *p = &w->out->piece[i];

    for (size_t k = 0; w->goal.trap && k < p->cells; k++) {
        const struct proof_cell *c = &w->out->cell[p->first + k];
        if (!is_trapped(w, p, c->to, c->after))
            continue;
        p->cells = k + 1;
        w->out->cells = p->first + k + 1;
        return true;
    }
    return false;
}

/* Piece i, from the end of the cone or its beginning: whether the goal is
 * reached, or why it cannot be. */
static bool pass(struct walk *w, size_t i, struct interval crossing[2])
{
    static const char no_tube[] = "no tube was proved";
    struct proof_branch *out = w->out;
    struct proof_piece *p = &out->piece[i];
    const struct proof_piece *next = i + 1 < out->pieces ? p + 1 : NULL;
    const bool is_last = w->goal.trap == NULL && i == w->goal.piece;
    const struct interval to =
        is_last ? theta_of(p, &w->goal) : proof_piece_end(p, next);

    out->not_proved = NULL;
    p->first = out->cells;
    const bool tube = proof_cells(w->tape, p, i == 0 ? out->cone.reach : 0, to,
                                  &w->front, out, &w->status);
    p->cells = out->cells - p->first;
    if (comes_in(w, i))
        return true;
    if (!tube)
        out->not_proved = no_tube;
    else if (is_last && !cross(w, p, to, crossing))
        out->not_proved = "its slope there has no sign";
    else if (!is_last && next == NULL)
        out->not_proved = "it does not come into a trap";
    else if (!is_last && !proof_join(w->tape, p, next, to, &w->front))
        out->not_proved = "the tube was lost at a corner";
    return is_last && !out->not_proved;
}

enum status proof_plane_branch(struct proof_plane *p,
                               const struct branch *curve,
                               const struct proof_goal *goal,
                               struct proof_branch *out,
                               struct interval crossing[2])
{
    struct walk w = { .tape = &p->tape, .goal = *goal, .out = out };

    *out = (struct proof_branch){ .not_proved = "the manifold was not grown" };
    w.status = proof_pieces(curve, out);
    if (w.status != STATUS_OK || out->pieces == 0)
        return w.status;
    if (goal->piece > 0 && goal->theta < PROOF_BEGINNING) {
        w.goal.piece--;
        w.goal.theta = 1;
    }
    const double most =
        goal->trap == NULL && w.goal.piece == 0 ? w.goal.theta : 1;
    if (!proof_cone(w.tape, out->piece, most, &out->cone, &w.front)) {
        out->not_proved = "no cone at the saddle is proved";
        return STATUS_OK;
    }
    out->not_proved = NULL;
    for (size_t i = 0; i < out->pieces; i++)
        if (pass(&w, i, crossing) || out->not_proved) {
            out->pieces = i + 1;
            break;
        }
    return w.status;
}
