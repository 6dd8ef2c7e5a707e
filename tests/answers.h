/* answers.h -- what push, simulate, whole orbits, maps and 113 bits tell of a
 * state, and whether that is one answer within its bars. */
#pragma once

#include "any_law.h"
#include "cells_of.h"
#include "push.h"
#include "quad_orbit.h"
#include "transient.h"

/* ---- a slope ------------------------------------------------------------- */

static const char *const grid[] = {
    "products=[basins, slip, time, friction, peak]",
    "basins={cells: [2, 2], audit: 0}", NULL
};

/* Must not move. */
struct draw {
    struct scene scene;  /* asks for a map */
    struct scene steady; /* borrows its members; for simulate */
    struct push push;
    struct study study; /* with critical numbers */
    struct quad_slope truth;
    char name[DRAWN_NAME];
};

static inline bool make(struct draw *d)
{
    struct fault why;

    d->steady = d->scene;
    d->steady.products = 1u << PRODUCT_EQUILIBRIA | 1u << PRODUCT_KNEES;
    if (push_init(&d->push, &d->scene, NULL, &why) != STATUS_OK)
        return false;
    if (study_run(&d->study, &d->steady, NULL, &why) != STATUS_OK) {
        push_free(&d->push);
        return false;
    }
    assert_int_equal(push_tabulate(&d->push, NULL), 0);
    quad_slope_init(&d->truth, &d->study);
    return true;
}

static inline void release(struct draw *d)
{
    push_free(&d->push);
    study_free(&d->study);
    scene_free(&d->scene);
}

enum kind { AT_SADDLE, AT_BOUNDARY, AT_CURVE, AT_CORNER, ANYWHERE, KINDS };
static const char *const kinds[KINDS] = { "saddle", "separatrix", "slow curve",
                                          "corner", "anywhere" };

static inline struct push_state state_of(const struct draw *d, struct vec2 z)
{
    const bool is_log = d->study.slider.plane.system.axis[1].is_log;
    return (struct push_state){ exp(z.x), is_log ? exp(z.y) : z.y };
}

/* ---- what each route tells ----------------------------------------------- */

enum route { BY_PUSH, BY_SIMULATE, BY_ORBIT, BY_MAP, ROUTES };
static const char *const routes[ROUTES] = { "push", "simulate", "orbit",
                                            "map" };

struct told {
    int fate;
    double value[CELL_FIELDS], bar[CELL_FIELDS]; /* NaN: none */
};

static inline void take(struct told *t, enum cell_field k,
                        const struct quantity *q)
{
    const bool is = quantity_exists(q);

    t->value[k] = is ? q->value : (double) NAN;
    t->bar[k] = is ? q->error : (double) NAN;
}

static inline struct told nothing(int fate)
{
    struct told t = { .fate = fate };

    for (int k = 0; k < CELL_FIELDS; k++)
        t.value[k] = t.bar[k] = (double) NAN;
    return t;
}

static inline struct told of_cell(const struct cell *c)
{
    struct told t = nothing(c->exit_reason);

    for (int k = 0; k < CELL_FIELDS; k++) {
        t.value[k] = value(c, (enum cell_field) k);
        t.bar[k] = error(c, (enum cell_field) k);
    }
    return t;
}

static inline struct told by_push(const struct draw *d, struct push_state at)
{
    struct push_answer a;

    assert_int_equal(push_find(&d->push, at, NULL, &a), 0);
    struct told t = nothing(a.fate);
    take(&t, CELL_SLIP, &a.slip);
    take(&t, CELL_TIME, &a.time);
    take(&t, CELL_MU_MEAN, &a.mu_mean);
    return t;
}

static inline struct told by_simulate(const struct draw *d,
                                      struct push_state at)
{
    const struct transient_options o = transient_defaults(&d->steady);
    const struct scene_start start = { .v = at.v, .psi = at.psi };
    struct transient run;

    assert_int_equal(transient_find(&d->study.slider, start, &o, NULL, &run),
                     0);
    struct told t = nothing(run.sum.fate);
    if (run.sum.end == TRANSIENT_ARREST || run.sum.end == TRANSIENT_REST) {
        take(&t, CELL_SLIP, &run.sum.slip);
        take(&t, CELL_TIME, &run.sum.time);
        take(&t, CELL_MU_MEAN, &run.sum.mu_mean);
    }
    transient_free(&run);
    return t;
}

static inline struct told by_orbit(const struct draw *d, struct vec2 z)
{
    struct cell c;

    assert_int_equal(fast_cells_find(&d->push.fast, &z, 1, d->scene.cell_rtol,
                                     ALL, NULL, &c, NULL),
                     0);
    return of_cell(&c);
}

/* ---- verdicts ------------------------------------------------------------ */

struct tally {
    size_t states, exact, fields, blurred, missing, overruled, lies;
    size_t undecided[KINDS];
    size_t tested[ROUTES][CELL_FIELDS];
    float *ratio[ROUTES][CELL_FIELDS]; /* bars over true errors */
};

struct place {
    const struct draw *d;
    enum kind kind;
    struct vec2 z;
};

static inline void lie(struct tally *t, const struct place *p, const char *text)
{
    if (t->lies++ == 0 || getenv("ANSWER_TELL"))
        print_message("# %s (%.17g, %.17g) at the %s: %s\n", p->d->name, p->z.x,
                      p->z.y, kinds[p->kind], text);
}

static inline void judge_field(struct tally *t, const struct place *p,
                               enum route r, enum cell_field k,
                               const struct told *told,
                               const struct quad_orbit *truth)
{
    const double off = (double) fabsq((quad) told->value[k] - truth->value[k]);
    const double bar = told->bar[k], own = truth->error[k];
    char text[300];

    if (isnan(told->value[k]) || isnan(own)) {
        t->missing += isnan(own) ? 0 : 1;
        return;
    }
    snprintf(text, sizeof text, "%s's %s %.17g +- %.3g, not %.17g +- %.1g",
             routes[r], record_cell.fields[1 + 2 * k].name, told->value[k], bar,
             (double) truth->value[k], own);
    if (!(off <= bar + own))
        lie(t, p, text);
    if (own > 0.01 * bar) {
        t->blurred++;
        return;
    }
    t->fields++;
    if (off > 0.0)
        t->ratio[r][k][t->tested[r][k]++] = (float) (bar / off);
}

/* A route against 113 bits. */
static inline void judge(struct tally *t, const struct place *p, enum route r,
                         const struct told *told,
                         const struct quad_orbit *truth)
{
    char text[200];

    if (told->fate == FATE_UNDECIDED || truth->fate == FATE_UNDECIDED)
        return;
    if (told->fate != (int) truth->fate) {
        snprintf(text, sizeof text, "%s says %s, not %s", routes[r],
                 fate_names[told->fate], fate_names[truth->fate]);
        lie(t, p, text);
        return;
    }
    for (int k = 0; k < CELL_FIELDS; k++)
        judge_field(t, p, r, (enum cell_field) k, told, truth);
}

/* Two routes against each other; false where they differ. */
static inline bool compare(struct tally *t, const struct place *p, enum route r,
                           const struct told *a, enum route q,
                           const struct told *b)
{
    const size_t before = t->lies;
    char text[300];

    if (a->fate == FATE_UNDECIDED || b->fate == FATE_UNDECIDED)
        return true;
    if (a->fate != b->fate) {
        snprintf(text, sizeof text, "%s says %s, %s %s", routes[r],
                 fate_names[a->fate], routes[q], fate_names[b->fate]);
        lie(t, p, text);
    }
    for (int k = 0; k < CELL_FIELDS && a->fate == b->fate; k++) {
        const double off = fabs(a->value[k] - b->value[k]);
        snprintf(text, sizeof text, "%s: %s %.17g +- %.3g, %s %.17g +- %.3g",
                 record_cell.fields[1 + 2 * k].name, routes[r], a->value[k],
                 a->bar[k], routes[q], b->value[k], b->bar[k]);
        if (off > a->bar[k] + b->bar[k])
            lie(t, p, text);
    }
    return t->lies == before;
}

/* ---- checks -------------------------------------------------------------- */

static inline struct quad_orbit truth_at(const struct draw *d,
                                         struct push_state at)
{
    const bool is_log = d->study.slider.plane.system.axis[1].is_log;
    struct quad_orbit o;

    quad_orbit_find(&d->truth, logq((quad) at.v),
                    is_log ? logq((quad) at.psi) : (quad) at.psi, 1e-8, &o);
    return o;
}

/* Which of its readings is held to 113 bits, whatever they say of each other:
 * push and simulate read the state, cells its place in the chart. */
enum { EXACT_NONE, EXACT_STATE, EXACT_POINT, EXACT_BOTH };

/* A block that fades for ever takes simulate seconds. */
static inline void check_state(const struct draw *d, enum kind kind,
                               struct push_state at, bool simulates,
                               unsigned exactly, struct tally *t)
{
    const bool is_log = d->study.slider.plane.system.axis[1].is_log;
    const struct vec2 z = { log(at.v), is_log ? log(at.psi) : at.psi };
    const struct place p = { d, kind, z };
    struct told simulated = nothing(FATE_UNDECIDED);
    struct quad_orbit truth;

    if (!push_holds(&d->push, at))
        return;
    const struct told pushed = by_push(d, at);
    struct told followed = by_orbit(d, z);
    if (followed.fate != pushed.fate) { /* the side tells, for fields too */
        t->overruled += pushed.fate != FATE_UNDECIDED;
        followed = nothing(FATE_UNDECIDED);
    }
    if ((simulates || exactly) && pushed.fate != FATE_REST_ASYMPTOTIC)
        simulated = by_simulate(d, at);
    t->states++;
    t->undecided[kind] += pushed.fate == FATE_UNDECIDED;
    const bool agree =
        compare(t, &p, BY_PUSH, &pushed, BY_SIMULATE, &simulated) &&
        compare(t, &p, BY_PUSH, &pushed, BY_ORBIT, &followed);
    if (agree && !exactly)
        return;
    t->exact++;
    if (!agree || exactly & EXACT_STATE) {
        truth = truth_at(d, at);
        judge(t, &p, BY_PUSH, &pushed, &truth);
        judge(t, &p, BY_SIMULATE, &simulated, &truth);
    }
    if (!agree || exactly & EXACT_POINT) {
        quad_orbit_find(&d->truth, (quad) z.x, (quad) z.y, 1e-8, &truth);
        judge(t, &p, BY_ORBIT, &followed, &truth);
    }
}

/* ---- report -------------------------------------------------------------- */

static inline int rising(const void *a, const void *b)
{
    const float x = *(const float *) a, y = *(const float *) b;
    return (x > y) - (x < y);
}

/* Medians of bars over true errors. */
static inline void print_ratios(struct tally *t)
{
    for (int r = 0; r < ROUTES; r++)
        for (int k = 0; k < CELL_FIELDS; k++) {
            const size_t n = t->tested[r][k];
            float *const ratio = t->ratio[r][k];
            if (n == 0)
                continue;
            qsort(ratio, n, sizeof *ratio, rising);
            print_message("# %-8s %-7s: %5zu, bars over errors: half %.3g, "
                          "nine of ten %.3g\n",
                          routes[r], record_cell.fields[1 + 2 * k].name, n,
                          (double) ratio[n / 2], (double) ratio[n * 9 / 10]);
        }
}

static inline void prepare(struct tally *t, size_t states)
{
    for (int r = 0; r < ROUTES; r++)
        for (int k = 0; k < CELL_FIELDS; k++)
            t->ratio[r][k] = calloc(states, sizeof(float));
}

static inline void finish(struct tally *t)
{
    print_message("# %zu states, %zu of them in 113 bits: %zu fields, %zu "
                  "blurred, %zu missing; %zu orbits overruled by their side, "
                  "%zu lies; undecided:",
                  t->states, t->exact, t->fields, t->blurred, t->missing,
                  t->overruled, t->lies);
    for (int k = 0; k < KINDS; k++)
        print_message(" %zu at the %s%s", t->undecided[k], kinds[k],
                      k + 1 < KINDS ? "," : "\n");
    print_ratios(t);
    for (int r = 0; r < ROUTES; r++)
        for (int k = 0; k < CELL_FIELDS; k++)
            free(t->ratio[r][k]);
}
