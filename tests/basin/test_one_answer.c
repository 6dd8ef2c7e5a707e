/* push (by its table), whole orbits, basin maps zoomed on a state, simulate and
 * 113 bits give one answer, within bars: fate, slip, time, friction and peaks
 * of random states of random laws, materials and slopes - next to the saddle,
 * next to the separatrix, next to the slow curve, at the corners of the boxes
 * of arrest and anywhere.
 *
 * Routes are held to each other, simulate at every tenth; one state in
 * ANSWER_EACH (24; 1: all) is held to 113 bits, some 0.1 s each.
 * ANSWER_STATES=20000 tries more than a test can afford, CHECK_SEED others,
 * ANSWER_TELL=1 prints each lie as it is found.
 */
#include "any_law.h"
#include "cells_of.h"
#include "push.h"
#include "quad_orbit.h"
#include "tolerance.h"
#include "transient.h"

#define NEAREST 1e-11
enum { EACH = 10, FEW = 2, MANY = 24, DISTANCES = 14 };

static size_t asked(const char *name, size_t usual)
{
    const char *asked = getenv(name);
    return asked ? (size_t) strtoul(asked, NULL, 10) : usual;
}

/* ---- random slopes ------------------------------------------------------- */

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

static bool make(struct draw *d)
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

static void release(struct draw *d)
{
    push_free(&d->push);
    study_free(&d->study);
    scene_free(&d->scene);
}

/* Three of four have a saddle. */
static void draw(size_t i, uint64_t *rng, struct draw *d)
{
    for (int attempt = 0; attempt < 200; attempt++) {
        slope_scene(&d->scene, "spinodal", NULL, "0.34", grid);
        d->scene.cell_rtol = pow(10.0, -4.0 - (double) (check_bits(rng) % 6));
        if (drawn_law(i, rng, &d->scene) && drawn_slope(rng, &d->scene) &&
            make(d)) {
            if (slider_saddle(&d->study.slider) >= 0 || attempt % 4 == 3) {
                drawn_name(i, &d->scene, d->name);
                return;
            }
            push_free(&d->push);
            study_free(&d->study);
        }
        scene_free(&d->scene);
    }
    fail_msg("no slope");
}

/* ---- states -------------------------------------------------------------- */

enum kind { AT_SADDLE, AT_BOUNDARY, AT_CURVE, AT_CORNER, ANYWHERE, KINDS };
static const char *const kinds[KINDS] = { "saddle", "separatrix", "slow curve",
                                          "corner", "anywhere" };

static double side(uint64_t *rng)
{
    return check_bits(rng) % 2 ? 1.0 : -1.0;
}

/* 10^-U(0, 14) */
static double distance(uint64_t *rng)
{
    return pow(10.0, -check_uniform(rng, 0.0, DISTANCES));
}

static struct push_state state_of(const struct draw *d, struct vec2 z)
{
    const bool is_log = d->study.slider.plane.system.axis[1].is_log;
    return (struct push_state){ exp(z.x), is_log ? exp(z.y) : z.y };
}

static struct vec2 anywhere(const struct draw *d, uint64_t *rng)
{
    const struct planar *p = &d->study.slider.plane.system;
    struct vec2 z;

    do
        z = (struct vec2){ p->origin.x + check_uniform(rng, -12, 12),
                           p->origin.y + check_uniform(rng, -7, 7) };
    while (!push_holds(&d->push, state_of(d, z)));
    return z;
}

static struct vec2 beside_saddle(const struct draw *d, uint64_t *rng)
{
    const double angle = check_uniform(rng, 0.0, 6.283185307179586);
    const double r = distance(rng);
    const struct vec2 z =
        d->study.slider.plane.equilibrium[slider_saddle(&d->study.slider)].z;

    return (struct vec2){ z.x + r * cos(angle), z.y + r * sin(angle) };
}

/* In the row of z. */
static struct vec2 beside_boundary(const struct draw *d, struct vec2 z,
                                   uint64_t *rng)
{
    struct push_answer a;

    assert_int_equal(push_find(&d->push, state_of(d, z), NULL, &a), 0);
    if (quantity_exists(&a.v_kick))
        z.x += log(a.v_kick.value) + side(rng) * distance(rng);
    return z;
}

static struct vec2 beside_curve(const struct draw *d, struct vec2 z,
                                uint64_t *rng)
{
    const struct vec2 origin = d->study.slider.plane.system.origin;
    struct slow_point p;

    if (slow_curve_at(&d->push.fast.curve, z.y - origin.y, &p))
        z.x = origin.x + p.x + side(rng) * distance(rng);
    return z;
}

/* Outside a box by so much of its size (or inside), next to a face of it or to
 * a corner. */
static struct vec2 beside_box(struct vec2 node, double off, uint64_t *rng)
{
    const double r = TOL_ARREST * (1.0 + off);

    node.x += side(rng) * r;
    node.y += side(rng) * (check_bits(rng) % 2 ? r : 0.5 * TOL_ARREST);
    return node;
}

/* Nearer to a face of the box than a state's digits are, nobody can tell on
 * which side it is. */
static struct vec2 at_corner(const struct draw *d, struct vec2 z, uint64_t *rng)
{
    const struct phase_plane *p = &d->study.slider.plane;

    for (size_t i = p->equilibria; i-- > 0;)
        if ((int) i != slider_saddle(&d->study.slider) &&
            check_bits(rng) % 2 == 0) {
            const double off = side(rng) * fmax(distance(rng), NEAREST);
            z = beside_box(p->equilibrium[i].z, off, rng);
        }
    return z;
}

static struct vec2 draw_point(const struct draw *d, enum kind kind,
                              uint64_t *rng)
{
    const struct vec2 z = anywhere(d, rng);

    switch (kind) {
        case AT_SADDLE:
            return slider_saddle(&d->study.slider) < 0 ? z
                                                       : beside_saddle(d, rng);
        case AT_BOUNDARY:
            return beside_boundary(d, z, rng);
        case AT_CURVE:
            return beside_curve(d, z, rng);
        case AT_CORNER:
            return at_corner(d, z, rng);
        default:
            return z;
    }
}

/* ---- what each route tells ----------------------------------------------- */

enum route { BY_PUSH, BY_SIMULATE, BY_ORBIT, BY_MAP, ROUTES };
static const char *const routes[ROUTES] = { "push", "simulate", "orbit",
                                            "map" };

struct told {
    int fate;
    double value[CELL_FIELDS], bar[CELL_FIELDS]; /* NaN: none */
};

static void take(struct told *t, enum cell_field k, const struct quantity *q)
{
    const bool is = quantity_exists(q);

    t->value[k] = is ? q->value : (double) NAN;
    t->bar[k] = is ? q->error : (double) NAN;
}

static struct told nothing(int fate)
{
    struct told t = { .fate = fate };

    for (int k = 0; k < CELL_FIELDS; k++)
        t.value[k] = t.bar[k] = (double) NAN;
    return t;
}

static struct told of_cell(const struct cell *c)
{
    struct told t = nothing(c->exit_reason);

    for (int k = 0; k < CELL_FIELDS; k++) {
        t.value[k] = value(c, (enum cell_field) k);
        t.bar[k] = error(c, (enum cell_field) k);
    }
    return t;
}

static struct told by_push(const struct draw *d, struct push_state at)
{
    struct push_answer a;

    assert_int_equal(push_find(&d->push, at, NULL, &a), 0);
    struct told t = nothing(a.fate);
    take(&t, CELL_SLIP, &a.slip);
    take(&t, CELL_TIME, &a.time);
    take(&t, CELL_MU_MEAN, &a.mu_mean);
    return t;
}

static struct told by_simulate(const struct draw *d, struct push_state at)
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

static struct told by_orbit(const struct draw *d, struct vec2 z)
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

static void lie(struct tally *t, const struct place *p, const char *text)
{
    if (t->lies++ == 0 || getenv("ANSWER_TELL"))
        print_message("# %s (%.17g, %.17g) at the %s: %s\n", p->d->name, p->z.x,
                      p->z.y, kinds[p->kind], text);
}

static void judge_field(struct tally *t, const struct place *p, enum route r,
                        enum cell_field k, const struct told *told,
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
static void judge(struct tally *t, const struct place *p, enum route r,
                  const struct told *told, const struct quad_orbit *truth)
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
static bool compare(struct tally *t, const struct place *p, enum route r,
                    const struct told *a, enum route q, const struct told *b)
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

static struct quad_orbit truth_at(const struct draw *d, struct push_state at)
{
    const bool is_log = d->study.slider.plane.system.axis[1].is_log;
    struct quad_orbit o;

    quad_orbit_find(&d->truth, logq((quad) at.v),
                    is_log ? logq((quad) at.psi) : (quad) at.psi, 1e-8, &o);
    return o;
}

/* push and simulate read the state, cells its place in the chart.  A block that
 * fades for ever takes simulate seconds. */
static void check_state(const struct draw *d, enum kind kind,
                        struct push_state at, bool simulates, bool exactly,
                        struct tally *t)
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
    truth = truth_at(d, at);
    judge(t, &p, BY_PUSH, &pushed, &truth);
    judge(t, &p, BY_SIMULATE, &simulated, &truth);
    quad_orbit_find(&d->truth, (quad) z.x, (quad) z.y, 1e-8, &truth);
    judge(t, &p, BY_ORBIT, &followed, &truth);
}

/* A cell of a map of cells x cells around a point, 10^-U(0, 12) wide. */
static void check_map(const struct draw *d, enum kind kind, size_t cells,
                      bool exactly, uint64_t *rng, struct tally *t)
{
    static struct cell c[MANY * MANY];
    static int8_t label[MANY * MANY];
    const double wide = pow(10.0, -check_uniform(rng, 0.0, 12.0));
    const struct vec2 z = draw_point(d, kind, rng);
    const size_t at = check_bits(rng) % (cells * cells);
    const struct vec2 half = { wide, wide };
    const struct push_state lo = state_of(d, vec2_sub(z, half));
    const struct push_state hi = state_of(d, vec2_add(z, half));
    struct scene scene = d->scene;
    struct study s;
    struct fault why;
    struct quad_orbit truth;

    if (!push_holds(&d->push, lo) || !push_holds(&d->push, hi))
        return;
    scene.cells[0] = scene.cells[1] = cells;
    scene.window =
        (struct scene_window){ .v = { lo.v, hi.v }, .psi = { lo.psi, hi.psi } };
    const enum status status = study_run(&s, &scene, NULL, &why);
    CHECK(status == STATUS_OK, "%s: %s", d->name, why.text);
    const struct basin_map *m = &s.basins;
    const struct place p = { d, kind, { m->x[at % cells], m->y[at / cells] } };
    assert_int_equal(fields_find(&s.fields, 0, cells, NULL, c), 0);
    assert_int_equal(basin_map_rows(m, 0, cells, label), 0);
    const struct told by_cell = of_cell(&c[at]), by_label = nothing(label[at]);
    compare(t, &p, BY_MAP, &by_cell, BY_MAP, &by_label);
    t->states++;
    t->undecided[kind] += by_cell.fate == FATE_UNDECIDED;
    if (exactly) {
        quad_orbit_find(&d->truth, (quad) p.z.x, (quad) p.z.y, 1e-8, &truth);
        judge(t, &p, BY_MAP, &by_cell, &truth);
        t->exact++;
    }
    study_free(&s);
}

/* ---- report -------------------------------------------------------------- */

static int rising(const void *a, const void *b)
{
    const float x = *(const float *) a, y = *(const float *) b;
    return (x > y) - (x < y);
}

/* Medians of bars over true errors. */
static void print_ratios(struct tally *t)
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

static void prepare(struct tally *t, size_t states)
{
    for (int r = 0; r < ROUTES; r++)
        for (int k = 0; k < CELL_FIELDS; k++)
            t->ratio[r][k] = calloc(states + EACH, sizeof(float));
}

static void finish(struct tally *t)
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

static void push_basin_simulate_and_113_bits_give_one_answer(void **state)
{
    const size_t states = asked("ANSWER_STATES", 500);
    const size_t each = asked("ANSWER_EACH", 24);
    static struct draw d;
    struct tally t = { 0 };
    uint64_t rng = check_seed();

    (void) state;
    if (laws_emulated())
        skip();
    prepare(&t, states);
    for (size_t i = 0; t.states < states; i++) {
        draw(i, &rng, &d);
        for (int k = 0; k < EACH; k++) {
            const enum kind kind = (enum kind)(k % KINDS);
            const bool exactly = (i * EACH + (size_t) k) % each == 0;
            if (k < EACH - 1)
                check_state(&d, kind, state_of(&d, draw_point(&d, kind, &rng)),
                            k == 0, exactly, &t);
            else
                check_map(&d, (enum kind)(check_bits(&rng) % KINDS),
                          i % 16 == 0 ? MANY : FEW, exactly, &rng, &t);
        }
        release(&d);
    }
    finish(&t);
    CHECK(t.overruled < t.states / 50, "%zu", t.overruled);
    CHECK(t.lies == 0, "%zu lies", t.lies);
}

/* ---- found --------------------------------------------------------------- */

/* A slope of a preset; of these states each was once told wrongly. */
static void make_preset(struct draw *d, const char *law, const char *alpha,
                        double rtol)
{
    slope_scene(&d->scene, law, NULL, alpha, grid);
    d->scene.cell_rtol = rtol;
    assert_true(make(d));
    snprintf(d->name, sizeof d->name, "%s at %s, rtol %g", law, alpha, rtol);
}

static void states_beside_boxes_of_arrest_slip_to_their_faces(void **state)
{
    static const double far[] = { 1e-11, -1e-11, 1e-9, -1e-9, 1e-7, 1e-2 };
    static const char *const law[] = { "spinodal_gen", "dieterich_gen",
                                       "spinodal" };
    static struct draw d;
    struct tally t = { 0 };
    uint64_t rng = check_seed();

    (void) state;
    if (laws_emulated())
        skip();
    prepare(&t, 100);
    for (size_t i = 0; i < sizeof law / sizeof *law; i++) {
        make_preset(&d, law[i], "0.34", 1e-6);
        const struct phase_plane *p = &d.study.slider.plane;
        for (size_t k = 0; k < 6 * p->equilibria; k++)
            if ((int) (k / 6) != slider_saddle(&d.study.slider)) {
                const struct vec2 z =
                    beside_box(p->equilibrium[k / 6].z, far[k % 6], &rng);
                check_state(&d, AT_CORNER, state_of(&d, z), true, true, &t);
            }
        release(&d);
    }
    finish(&t);
    CHECK(t.lies == 0, "%zu lies", t.lies);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(states_beside_boxes_of_arrest_slip_to_their_faces),
        cmocka_unit_test(push_basin_simulate_and_113_bits_give_one_answer),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
