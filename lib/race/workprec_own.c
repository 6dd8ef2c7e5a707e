#include "workprec_own.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "fast_cells.h"
#include "grow.h"
#include "study_tolerance.h"
#include "tolerance.h"
#include "workprec_count.h"

enum status workprec_shared_init(struct workprec_shared *k,
                                 const struct workprec_task *c)
{
    *k = (struct workprec_shared){ calloc(1, sizeof *k->slow) };
    if (k->slow == NULL)
        return STATUS_NO_MEMORY;
    const enum status s = fast_cells_init(k->slow, &c->study->slider, NULL);
    if (s != STATUS_OK)
        workprec_shared_free(k);
    return s;
}

void workprec_shared_free(struct workprec_shared *k)
{
    if (k->slow)
        fast_cells_free(k->slow);
    free(k->slow);
    k->slow = NULL;
}

/* ---- branches -------------------------------------------------------- */

/* How the branches of a quantity are made. */
struct maker {
    const struct workprec_task *c;
    enum workprec_own how;
    double tol;
    struct carry carry;
    const struct box *window; /* absolute; NULL: to the limits */
    struct workprec_answer *out;
};

static void count(const struct maker *m, const struct branch *b, size_t order)
{
    m->out->calls += b->evaluations * order;
    m->out->steps += b->steps;
}

/* Side by side, as a study has them. */
static enum status grow_both(const struct maker *m,
                             const struct local_series *u, int up,
                             const struct grow_options *o,
                             struct branch branch[WORKPREC_SIDES])
{
    struct branch both[2]; /* of s > 0, s < 0 */
    const enum status s =
        grow_branches(&m->c->study->slider.plane.system, u, o, both);

    branch[SIDE_UPPER] = both[up > 0 ? 0 : 1];
    branch[SIDE_LOWER] = both[up > 0 ? 1 : 0];
    for (int i = 0; i < WORKPREC_SIDES; i++)
        count(m, &branch[i], o->order);
    return s;
}

static enum status make_sides(const struct maker *m, const bool wanted[],
                              struct branch branch[WORKPREC_SIDES])
{
    const struct planar *sys = &m->c->study->slider.plane.system;
    struct grow_options o = grow_defaults(m->tol);
    struct local_series u;

    for (int i = 0; i < WORKPREC_SIDES; i++)
        branch[i] = (struct branch){ .end = BRANCH_STEPS };
    o.carry = m->carry;
    o.reach = m->window;
    enum status s = local_at(sys, m->c->saddle, MANIFOLD_STABLE, &m->carry,
                             o.order, TOL_TAYLOR_STEP * m->tol, &u);
    if (s != STATUS_OK)
        return s;
    const int up = u.ind == 0 || u.c[1] > 0.0 ? 1 : -1;
    if (wanted[SIDE_UPPER] && wanted[SIDE_LOWER])
        return grow_both(m, &u, up, &o, branch);
    const int side = wanted[SIDE_UPPER] ? SIDE_UPPER : SIDE_LOWER;
    s = grow_branch(sys, &u, side == SIDE_UPPER ? up : -up, &o, &branch[side]);
    count(m, &branch[side], o.order);
    return s;
}

static void report(struct workprec_answer *out, const struct quantity *q)
{
    out->success = quantity_exists(q);
    out->value[0] = q->value;
    out->reported = q->error / fabs(q->value);
}

static enum status find_limit(const struct maker *m, enum workprec_quantity q)
{
    const int side = q == WORKPREC_V_MINUS ? SIDE_LOWER : SIDE_UPPER;
    const bool wanted[] = { side == SIDE_UPPER, side == SIDE_LOWER };
    struct branch branch[WORKPREC_SIDES];
    const enum status s = make_sides(m, wanted, branch);

    if (s == STATUS_OK) {
        const struct critical_numbers n =
            numbers_critical(&m->c->study->slider.block, m->c->saddle,
                             &branch[SIDE_UPPER], &branch[SIDE_LOWER]);
        report(m->out, q == WORKPREC_V_PLUS    ? &n.v_plus
                       : q == WORKPREC_V_MINUS ? &n.v_minus
                                               : &n.x_excess);
    }
    branch_free(&branch[SIDE_UPPER]);
    branch_free(&branch[SIDE_LOWER]);
    return s;
}

/* A few roundings of a point's absolute coordinates. */
static double rounding(const struct workprec_task *c, struct vec2 z)
{
    const struct vec2 o = c->study->slider.plane.system.origin;

    return 4.0 * DBL_EPSILON *
           (1.0 + fabs(o.x) + fabs(o.y) + fabs(z.x) + fabs(z.y));
}

/* Ends and middles of its pieces, as far as they are in the window. */
static void store_points(const struct maker *m, const struct branch *b,
                         int side)
{
    struct workprec_answer *a = m->out;

    for (size_t i = 0; i < 2 * b->curve.count; i++) {
        const struct vec2 z = curve_point(&b->curve, i / 2, i % 2 ? 1.0 : 0.5);
        if (!box_holds(m->c->reach, z) ||
            a->points[side] == WORKPREC_POINTS_MOST)
            return;
        a->point[side][a->points[side]++] = z;
        a->reported =
            fmax(a->reported, b->curve.piece[i / 2].error + rounding(m->c, z));
    }
}

static enum status find_curve(const struct maker *m)
{
    const bool wanted[] = { true, true };
    struct branch branch[WORKPREC_SIDES];
    const enum status s = make_sides(m, wanted, branch);

    m->out->reported = 0.0;
    for (int i = 0; i < WORKPREC_SIDES; i++) {
        m->out->points[i] = 0;
        if (s == STATUS_OK)
            store_points(m, &branch[i], i);
        branch_free(&branch[i]);
    }
    m->out->success = s == STATUS_OK;
    return s;
}

/* Of the crossings of a row the one on its side; x as an offset. */
static void cut(const struct maker *m, const struct separatrix *s, int side,
                size_t k)
{
    const struct vec2 o = m->c->study->slider.plane.system.origin;
    const double row = o.y + m->c->truth.cuts[side].row[k];

    for (size_t i = 0; i < s->count; i++) {
        if (!(row >= s->strand[i].lo && row < s->strand[i].hi))
            continue;
        const struct crossing x = separatrix_cross(s, i, row);
        const double z = x.at - o.x;
        if ((z > 0.0) != (side == SIDE_UPPER))
            continue;
        m->out->value[side * WORKPREC_ROWS_MOST + (int) k] = z;
        m->out->reported =
            fmax(m->out->reported,
                 x.error + rounding(m->c, (struct vec2){ z, row - o.y }));
        return;
    }
    m->out->success = false;
}

static enum status find_rows(const struct maker *m)
{
    const bool wanted[] = { true, true };
    struct branch branch[WORKPREC_SIDES];
    struct separatrix s =
        separatrix_empty(SEPARATRIX_Y, m->c->study->slider.plane.system.origin);
    enum status status = make_sides(m, wanted, branch);

    m->out->success = true;
    m->out->reported = 0.0;
    if (status == STATUS_OK)
        status = separatrix_add(&s, &branch[SIDE_LOWER], &branch[SIDE_UPPER]);
    for (int i = 0; i < WORKPREC_SIDES && status == STATUS_OK; i++)
        for (size_t k = 0; k < m->c->truth.cuts[i].count; k++)
            cut(m, &s, i, k);
    separatrix_free(&s);
    branch_free(&branch[SIDE_UPPER]);
    branch_free(&branch[SIDE_LOWER]);
    return status;
}

/* ---- orbits ---------------------------------------------------------- */

static enum status follow(const struct maker *m, double rtol,
                          struct drift *drift, struct orbit *o)
{
    const struct study *s = m->c->study;
    struct orbit_options options =
        orbit_defaults(&s->slider.plane.system, s->slider.plane.fastest_rate);

    if (drift)
        drift_start(drift, slider_rounding(&s->slider, m->c->start),
                    phase_plane_leaving_rate(&s->slider.plane));
    options.drift = drift;
    options.rtol = rtol;
    options.observables = 0;
    options.reach[0] = m->c->until;
    enum status status =
        orbit_init(o, &s->slider.plane.system, m->c->start, &options);
    if (status == STATUS_OK)
        status = orbit_run(o, NULL);
    m->out->calls += o->field_calls + o->jacobian_calls;
    m->out->steps += o->steps;
    return status;
}

/* The bar of component i at a time; as in transient.c it is too small by as
 * much as two orbits are further apart than theirs. */
static double bar_of(const struct orbit *coarse, const struct orbit *fine,
                     int i)
{
    const struct orbit *both[2] = { coarse, fine };
    struct quantity q[2];

    for (int k = 0; k < 2; k++) {
        const struct orbit *o = both[k];
        q[k] = quantity_of(o->u[i],
                           drift_bar_at(o->options.drift, 2, (size_t) i) +
                               TOL_ROUNDINGS * DBL_EPSILON * fabs(o->u[i]));
    }
    return fate_compare(&q[0], &q[1]).error;
}

/* Two orbits, of tolerances as transient.h has them; or only one, without a
 * bar. */
static enum status find_state(const struct maker *m)
{
    struct orbit coarse = { .steps = 0 }, fine = { .steps = 0 };
    struct drift drift[2];
    struct workprec_answer *a = m->out;
    const bool bars = m->how == WORKPREC_SLIPWAY;
    const double rtol = fmax(m->tol, TOL_TRANSIENT_FINEST);

    enum status s =
        bars ? follow(m, rtol / TOL_FINER, &drift[0], &coarse) : STATUS_OK;
    if (s == STATUS_OK)
        s = follow(m, rtol, bars ? &drift[1] : NULL, &fine);
    a->success = s == STATUS_OK && fine.end == ORBIT_REACHED;
    a->reported = bars ? 0.0 : (double) NAN;
    for (int i = 0; i < 2 && s == STATUS_OK; i++) {
        a->value[i] = fine.u[i];
        if (bars)
            a->reported = fmax(a->reported, bar_of(&coarse, &fine, i));
    }
    orbit_free(&coarse);
    orbit_free(&fine);
    return s;
}

/* One orbit each, whose errors are sums of estimates and no bars. */
static enum status find_slips_alone(const struct maker *m)
{
    enum status s = STATUS_OK;

    m->out->success = true;
    for (size_t k = 0; k < m->c->cells && s == STATUS_OK; k++) {
        struct fate_result r;
        s = fate_find(&m->c->study->slider, m->c->cell[k], m->tol, true, NULL,
                      &r);
        m->out->value[k] = r.slip.value;
        m->out->success &= s == STATUS_OK && quantity_exists(&r.slip);
        m->out->calls += r.field_evaluations;
        m->out->steps += r.steps;
    }
    return s;
}

static enum status find_slips(const struct maker *m,
                              const struct workprec_shared *shared)
{
    struct workprec_answer *a = m->out;
    const struct workprec_task *c = m->c;
    const unsigned which = 1u << CELL_SLIP;
    struct cell cell[WORKPREC_CELLS_MOST];

    if (m->how == WORKPREC_RADAU)
        return find_slips_alone(m);
    const enum status s = m->how == WORKPREC_SLOW
                              ? fast_cells_find(shared->slow, c->cell, c->cells,
                                                m->tol, which, NULL, cell, NULL)
                              : cells_find(&c->study->slider, c->cell, c->cells,
                                           m->tol, which, NULL, cell);
    a->success = s == STATUS_OK;
    a->reported = 0.0;
    for (size_t k = 0; k < c->cells && s == STATUS_OK; k++) {
        a->value[k] = cell[k].slip;
        a->success &= isfinite(cell[k].slip);
        a->reported =
            fmax(a->reported, cell[k].slip_error / fabs(cell[k].slip));
    }
    return s;
}

void workprec_own_run(const struct workprec_task *c,
                      const struct workprec_shared *shared,
                      enum workprec_own how, enum workprec_quantity q,
                      double tol, struct workprec_answer *out)
{
    const struct box window = c->plane ? c->study->slider.plane.system.domain
                                       : scene_box(c->study->scene);
    struct maker m = { .c = c, .how = how, .tol = tol, .out = out };
    enum status s;

    out->success = false;
    out->calls = out->steps = 0;
    out->reported = (double) NAN;
    if (q == WORKPREC_X_EXCESS)
        m.carry = (struct carry){ { BLOCK_EXCESS }, 1 };
    if (q == WORKPREC_CURVE || q == WORKPREC_ROWS)
        m.window = &window;
    if (q == WORKPREC_CURVE)
        s = find_curve(&m);
    else if (q == WORKPREC_ROWS)
        s = find_rows(&m);
    else if (q == WORKPREC_TRANSIENT)
        s = find_state(&m);
    else if (q == WORKPREC_SLIP)
        s = find_slips(&m, shared);
    else
        s = find_limit(&m, q);
    out->success &= s == STATUS_OK;
}

/* The states once more, in a copy of the study that counts. */
enum status workprec_own_count(const struct workprec_task *c,
                               enum workprec_own how, double tol,
                               struct workprec_answer *out)
{
    struct workprec_task task = *c;
    struct study *study = malloc(sizeof *study);
    struct workprec_shared shared = { NULL };
    size_t calls = 0;
    struct workprec_counter counter = { .system = c->study->slider.plane.system,
                                        .calls = &calls };

    if (study == NULL)
        return STATUS_NO_MEMORY;
    *study = *c->study;
    study->slider.plane.system = workprec_counted(&counter);
    task.study = study;
    const enum status s = workprec_shared_init(&shared, &task);
    if (s == STATUS_OK) {
        calls = 0;
        workprec_own_run(&task, &shared, how, WORKPREC_SLIP, tol, out);
        out->calls = calls;
    }
    workprec_shared_free(&shared);
    free(study);
    return s;
}
