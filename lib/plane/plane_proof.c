#include "plane_proof.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "proof_input.h"
#include "proof_plane.h"
#include "proof_short.h"

const char *const plane_proved_names[] = { "not_proved", "crosses", "trapped",
                                           NULL };

enum { OF_A_REST = 6, OF_A_BRANCH = 2 };

/* ---- what is told -------------------------------------------------------- */

static struct proved *next_of(struct plane_study *s, struct quantity *q)
{
    struct proved *p = s->proof.of[s->proof.count++];

    q->proved = p;
    return p;
}

/* What it is of: an equilibrium, or where a branch leaves; which of its
 * numbers. */
static void tell(struct plane_study *s, struct quantity *q,
                 struct interval wide, const char *whose, const char *number)
{
    const struct interval_double u = interval_outward(wide);
    struct proved *p = next_of(s, q);

    p[0] = p[1] =
        interval_is_finite(wide)
            ? (struct proved){ .lo = u.lo, .hi = u.hi }
            : (struct proved){ .not_proved = "its enclosure is not finite" };
    if (!quantity_exists(q) || s->proof.lie.text[0] ||
        (q->value - q->error <= u.hi && u.lo <= q->value + q->error))
        return;
    snprintf(s->proof.lie.text, sizeof s->proof.lie.text, "%s %s: " PROVED_LIE,
             whose, number);
}

static void tell_rest(struct plane_study *s, struct plane_rest *r)
{
    for (int i = 0; i < 2; i++) {
        tell(s, &r->state[i], proof_plane_number(&r->exact.state[i]), r->name,
             s->system[0].axis[i].name);
        tell(s, &r->lambda[i].re,
             proof_plane_number(&r->exact.eigenvalue[i].re), r->name,
             "eigenvalue");
        tell(s, &r->lambda[i].im,
             proof_plane_number(&r->exact.eigenvalue[i].im), r->name,
             "eigenvalue");
    }
}

/* ---- the goals of a branch ----------------------------------------------- */

/* A place of the chart, of a rest. */
static struct interval place_of(const struct plane_rest *r, int axis)
{
    return proof_plane_number(&r->exact.chart[axis]);
}

double plane_proof_edge(const struct plane_study *s,
                        const struct plane_branch *b)
{
    const struct scene_window *w = &s->scene->window;

    return (b->edge / 2 == 0 ? w->v : w->psi)[b->edge % 2];
}

static struct proof_goal goal_of_edge(const struct plane_study *s,
                                      const struct plane_branch *b)
{
    const int axis = b->edge / 2;
    const struct interval edge = proof_decimal(plane_proof_edge(s, b));
    const struct interval at =
        scene_axis_is_log(s->scene, axis) ? interval_ln(edge) : edge;

    return (struct proof_goal){
        .axis = axis,
        .at = interval_less(at, place_of(&s->rest[b->rest], axis)),
        .piece = b->shown - 1,
        .theta = b->shown_to,
    };
}

/* Of an angle, from the equilibrium to the end of the branch. */
static double turns_of(const struct plane_study *s,
                       const struct plane_branch *b, int axis)
{
    const double period = (double) s->scene->system->state[axis].period;
    const struct plane_rest *from = &s->rest[b->rest], *to = &s->rest[b->to];
    double end[CURVE_DIM_MAX];

    if (!(period > 0))
        return 0;
    curve_at(&b->curve.curve, b->curve.curve.count - 1, 1.0, end);
    return rint((axis == 0 ? end[0] + from->z.x - to->z.x
                           : end[1] + from->z.y - to->z.y) /
                period);
}

/* The ellipse of arrival.h, in the chart. */
static void set_trap(const struct plane_study *s, const struct plane_branch *b,
                     struct plane_tube *u)
{
    const struct plane_rest *from = &s->rest[b->rest], *to = &s->rest[b->to];
    const struct trap_form *t = &to->trap[b->kind == MANIFOLD_STABLE];
    const struct vec2 side = s->scale.side;

    u->trap = (struct proof_trap){ .xx = t->pxx / (side.x * side.x),
                                   .xy = t->pxy / (side.x * side.y),
                                   .yy = t->pyy / (side.y * side.y),
                                   .level = t->size * t->size };
    for (int i = 0; i < 2; i++) {
        const struct system_number period = { s->scene->system->state[i].period,
                                              0 };
        u->turns[i] = turns_of(s, b, i);
        u->trap.at[i] =
            add(interval_less(place_of(to, i), place_of(from, i)),
                times(point(u->turns[i]), proof_plane_number(&period)));
    }
}

/* ---- a branch ------------------------------------------------------------ */

static const char *no_goal(const struct plane_branch *b)
{
    return b->end == PLANE_END_SADDLE  ? "it comes to a saddle"
           : b->end == PLANE_END_CYCLE ? "it winds on to a closed orbit"
           : b->end == PLANE_END_EQUILIBRIUM
               ? "it comes to an equilibrium outside the window"
               : "its end is not known";
}

static void tell_crossing(struct plane_study *s, struct plane_branch *b,
                          const struct interval crossing[2])
{
    const int axis = b->edge / 2, other = 1 - axis;
    const struct plane_rest *r = &s->rest[b->rest];
    const struct interval at = add(place_of(r, other), crossing[other]);

    tell(s, &b->leaves[axis], proof_decimal(plane_proof_edge(s, b)), r->name,
         "leaves");
    tell(s, &b->leaves[other],
         scene_axis_is_log(s->scene, other) ? interval_exp(at) : at, r->name,
         "leaves");
}

static enum status follow(struct plane_study *s, struct plane_branch *b,
                          struct proof_plane *p, struct plane_tube *u)
{
    const bool leaves = quantity_exists(&b->leaves[0]);
    struct proof_goal goal = { .trap = &u->trap };
    struct interval crossing[2];
    enum status status = STATUS_OK;

    if (leaves) {
        goal = goal_of_edge(s, b);
    } else {
        set_trap(s, b, u);
        if (!(u->trap.level > 0) || !proof_trap_verify(&p->tape, &u->trap)) {
            b->not_proved = "no trap was proved";
            return STATUS_OK;
        }
    }
    status = proof_plane_branch(p, &b->curve, &goal, &u->tube, crossing);
    b->not_proved = u->tube.not_proved;
    if (status != STATUS_OK || b->not_proved)
        return status;
    b->end_proved = leaves ? PLANE_CROSSES : PLANE_TRAPPED;
    if (leaves)
        tell_crossing(s, b, crossing);
    return STATUS_OK;
}

static enum status prove_goal(struct plane_study *s, struct plane_branch *b,
                              struct plane_tube *u)
{
    const int way = b->kind == MANIFOLD_STABLE ? 0 : 1;
    struct proof_plane p;
    struct fault why;
    enum status status =
        proof_plane_at(&p, &s->lowered->way[1][way], s->lowered->value,
                       s->rest[b->rest].exact.chart, &why);

    if (status == STATUS_BAD_ARGUMENT)
        b->not_proved = "a function has no rule";
    else if (status == STATUS_OK)
        status = follow(s, b, &p, u);
    proof_plane_free(&p);
    return status == STATUS_BAD_ARGUMENT ? STATUS_OK : status;
}

static enum status prove_branch(struct plane_study *s, struct plane_branch *b,
                                struct plane_tube *u)
{
    const bool leaves = quantity_exists(&b->leaves[0]);
    enum status status = STATUS_OK;

    b->end_proved = PLANE_NOT_PROVED;
    b->not_proved = no_goal(b);
    if (leaves ||
        (b->end == PLANE_END_EQUILIBRIUM && b->to != RECORD_COUNT_NONE))
        status = prove_goal(s, b, u);
    for (int i = 0; i < 2 && leaves && b->not_proved; i++)
        *next_of(s, &b->leaves[i]) =
            (struct proved){ .not_proved = b->not_proved };
    return status;
}

/* ---- all ----------------------------------------------------------------- */

enum status plane_proof_find(struct plane_study *s)
{
    const size_t most =
        OF_A_REST * s->listed + OF_A_BRANCH * s->listed_branches;
    enum status status = STATUS_OK;

    s->proof.of = calloc(most + 1, sizeof *s->proof.of);
    s->proof.tube = calloc(s->listed_branches + 1, sizeof *s->proof.tube);
    if (s->proof.of == NULL || s->proof.tube == NULL)
        return STATUS_NO_MEMORY;
    for (size_t i = 0; i < s->listed; i++)
        tell_rest(s, &s->rest[i]);
    for (size_t *i = &s->proof.tubes;
         *i < s->listed_branches && status == STATUS_OK; ++*i)
        status = prove_branch(s, &s->branch[*i], &s->proof.tube[*i]);
    return status;
}

bool plane_proof_is_of(const struct result *r, const struct record_field *f)
{
    static const char *const name[] = { "equilibria[K].state",
                                        "equilibria[K].eigenvalues" };
    bool found = strncmp(f->name, "leaves_", 7) == 0;

    for (size_t i = 0; i < sizeof name / sizeof *name && r->name; i++)
        found = found || strcmp(r->name, name[i]) == 0;
    return found;
}

void plane_proof_withdraw(struct plane_proof *p)
{
    for (size_t i = 0; i < p->count && p->lie.text[0]; i++)
        p->of[i][0] = p->of[i][1] =
            (struct proved){ .not_proved = p->lie.text };
}

void plane_proof_free(struct plane_proof *p)
{
    for (size_t i = 0; i < p->tubes; i++) {
        free(p->tube[i].tube.piece);
        free(p->tube[i].tube.cell);
    }
    free(p->tube);
    free(p->of);
    *p = (struct plane_proof){ .of = NULL };
}
