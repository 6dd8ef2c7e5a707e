/* Labels of states by their side of the separatrix, against orbits in 113
 * bits; of maps, against labels of states. */
#include "labels.h"

#include "fault_alloc.h"
#include "laws.h"
#include "push.h"
#include "quad_side.h"
#include "random_slope.h"
#include "transient.h"

/* ---- sides --------------------------------------------------------------- */

/* A state at a distance from the saddle of 10^-14 to far away, beside the
 * separatrix: off it by 10^-17 to 1 of that, in v or in psi. */
static struct push_state beside(const struct labels *l, uint64_t *rng)
{
    const struct slider *s = l->slider;
    const struct separatrix *rows = &l->along[SEPARATRIX_Y];
    const double size = pow(10.0, check_uniform(rng, -14.0, 0.5));
    const double y = check_bits(rng) & 1 ? size : -size;
    struct vec2 z = { y, y };
    struct crossing c[8];

    if (separatrix_row(rows, y, c) > 0)
        z.x = fmin(fmax(c[0].at, -300.0), 300.0);
    const double shift = hypot(z.x, z.y) *
                         pow(10.0, check_uniform(rng, -17.0, 0.0)) *
                         (check_bits(rng) & 1 ? 1.0 : -1.0);
    *(check_bits(rng) & 1 ? &z.x : &z.y) += shift;
    const long double x = s->block.x + z.x, w = s->block.y + z.y;
    return (struct push_state){ (double) expl(x), s->plane.system.axis[1].is_log
                                                      ? (double) expl(w)
                                                      : (double) w };
}

/* The nearest crossing of a line through the state. */
static double nearest(const struct separatrix *s, double w, double at)
{
    struct crossing c[256];
    double d = HUGE_VAL;

    assert_true(s->count < 256);
    for (size_t k = separatrix_row(s, w, c); k-- > 0;)
        d = fmin(d, fabs(c[k].at - at));
    return d;
}

/* From the separatrix, about. */
static double distance(const struct labels *l, struct vec2 z)
{
    const double x = nearest(&l->along[SEPARATRIX_Y], z.y, z.x);
    const double y = nearest(&l->along[SEPARATRIX_X], z.x, z.y);

    return fmin(x, y);
}

/* Certain only if right, uncertain only within some tens of roundings. */
static void check_side(const struct labels *l, const struct quad_side *o,
                       struct push_state at, size_t *certain)
{
    const struct slider *s = l->slider;
    const struct vec2 z = block_offset(&s->block, at.v, at.psi);
    struct fate_told label;

    assert_int_equal(labels_find(l, z, NULL, &label), STATUS_OK);
    if (label.fate == FATE_UNDECIDED) {
        const double bar = l->along[0].slack + 1e-11 * hypot(z.x, z.y);
        CHECK(distance(l, z) < 10.0 * bar,
              "%s at alpha = %.17g: v = %.17g, psi = %.17g: undecided",
              s->block.law.preset, atan((double) s->block.tan_alpha), at.v,
              at.psi);
        return;
    }
    const int side = quad_side_of_state(o, at.v, at.psi);
    ++*certain;
    CHECK(side == 2 || label.fate == (int8_t) fate_of_side(s, side == 0),
          "%s at alpha = %.17g: v = %.17g, psi = %.17g: %s",
          s->block.law.preset, atan((double) s->block.tan_alpha), at.v, at.psi,
          fate_names[label.fate]);
}

static void random_states_are_on_the_side_that_113_bits_say(void **state)
{
    enum { SLOPES = 30, STATES = 8 };
    uint64_t rng = check_seed();
    size_t certain = 0;

    (void) state;
    for (int i = 0; i < SLOPES; i++) {
        struct slope s;
        struct labels l;
        random_slope(&s, &rng, "products=[equilibria]");
        assert_int_equal(labels_init(&l, &s.study.slider, s.scene.rtol, NULL),
                         STATUS_OK);
        const struct quad_side o = quad_side_of(&s.study);
        for (int k = 0; k < STATES; k++) {
            check_side(&l, &o, beside(&l, &rng), &certain);
        }
        labels_free(&l);
        slope_free(&s);
    }
    print_message("# %zu of %d told\n", certain, SLOPES * STATES);
    CHECK(certain > SLOPES * STATES / 2, "%zu", certain);
}

/* Beside the curve that was followed to the end of the plane, also where the
 * numbers' has ended. */
static struct vec2 beside_far(const struct labels *l, uint64_t *rng)
{
    const double size = pow(10.0, check_uniform(rng, -3.0, 2.5));
    struct vec2 z = { size, check_bits(rng) & 1 ? size : -size };
    struct crossing c[8];

    if (separatrix_row(&l->along[SEPARATRIX_Y], z.y, c) > 0)
        z.x = c[0].at;
    const double shift = pow(10.0, check_uniform(rng, -13.0, 0.0));
    z.x += check_bits(rng) & 1 ? shift : -shift;
    return z;
}

static void curves_of_numbers_tell_no_other_side(void **state)
{
    enum { SLOPES = 60, STATES = 60 };
    uint64_t rng = check_seed();
    size_t told = 0;

    (void) state;
    for (int i = 0; i < SLOPES; i++) {
        struct slope s;
        struct labels own, lent;
        random_slope(&s, &rng, "products=[knees]");
        const struct slider *slider = &s.study.slider;
        assert_int_equal(labels_init(&own, slider, s.scene.rtol, NULL),
                         STATUS_OK);
        assert_int_equal(labels_lend(&lent, slider, s.study.stable), STATUS_OK);
        for (int k = 0; k < STATES; k++) {
            const struct vec2 z = beside_far(&own, &rng);
            const enum fate side = labels_side(&lent, z);
            struct fate_told label;
            assert_int_equal(labels_find(&own, z, NULL, &label), STATUS_OK);
            told += side != FATE_UNDECIDED;
            CHECK(side == FATE_UNDECIDED || label.fate == FATE_UNDECIDED ||
                      label.fate == (int8_t) side,
                  "%s at alpha = %.17g: (%g, %g) off the saddle: %s, not %s",
                  slider->block.law.preset, s.scene.alpha, z.x, z.y,
                  fate_names[side], fate_names[label.fate]);
        }
        labels_free(&lent);
        labels_free(&own);
        slope_free(&s);
    }
    CHECK(told > SLOPES * STATES / 2, "%zu told", told);
}

/* As `knees` prints it, and one unit in the last place beside it. */
static void at_the_saddle_nothing_is_told(void **state)
{
    uint64_t rng = check_seed();

    (void) state;
    for (size_t i = 0; i < random_presets(); i++) {
        static const char *const set[] = { "products=[equilibria]", NULL };
        struct slope s;
        struct labels l;
        random_slope_of(&s, i, &rng, set);
        assert_int_equal(labels_init(&l, &s.study.slider, s.scene.rtol, NULL),
                         STATUS_OK);
        const double v = s.study.saddle_numbers.v.value;
        const double psi = s.study.saddle_numbers.psi.value;
        for (int k = 0; k < 9; k++) {
            const double to[3] = { -HUGE_VAL, 0.0, HUGE_VAL };
            const double x = k % 3 == 1 ? v : nextafter(v, to[k % 3]);
            const double y = k / 3 == 1 ? psi : nextafter(psi, to[k / 3]);
            const struct vec2 z = block_offset(&s.study.slider.block, x, y);
            struct fate_told label;
            assert_int_equal(labels_find(&l, z, NULL, &label), STATUS_OK);
            CHECK(label.fate == FATE_UNDECIDED && label.reason,
                  "%s: v = %.17g, psi = %.17g: %s",
                  s.study.slider.block.law.preset, x, y,
                  fate_names[label.fate]);
        }
        labels_free(&l);
        slope_free(&s);
    }
}

/* ---- maps ---------------------------------------------------------------- */

/* Orbits agree with it, and shares sum to one. */
static void check_map(const struct slope *s)
{
    const struct basin_map *m = &s->study.basins;
    const struct block *b = &s->study.slider.block;
    double sum = 0.0;

    for (int i = 0; i < FATES; i++)
        sum += m->fraction[i].log.value;
    CHECK(m->audit.cells == 50 && m->audit.disagreements == 0 &&
              fabs(sum - 1.0) < 1e-9,
          "%s (%s %s %s %s %s), L = %.17g, V_star = %.17g, alpha = %.17g: %zu "
          "cells wrong, shares sum to %.17g",
          b->law.preset, friction_form_names[b->law.form],
          theta_names[b->law.theta], psi_ss_names[b->law.psi_ss],
          timescale_names[b->law.timescale], kinetics_names[b->law.kinetics],
          b->material.L, b->material.V_star, s->scene.alpha,
          m->audit.disagreements, sum);
}

static const char *const map[] = { "products=[basins]",
                                   "basins={cells: [32, 32], audit: 50}",
                                   NULL };

/* MAP_SLOPES: slopes of each law. */
static size_t map_slopes(size_t usual)
{
    const char *asked = getenv("MAP_SLOPES");
    return asked ? strtoul(asked, NULL, 10) : usual;
}

/* One half in each form. */
static void random_maps_have_the_fates_of_their_orbits(void **state)
{
    const size_t slopes = map_slopes(3);
    uint64_t rng = check_seed();

    (void) state;
    for (size_t i = 0; i < slopes * random_presets(); i++) {
        struct slope s;
        random_slope_of(&s, i % random_presets(), &rng, map);
        check_map(&s);
        slope_free(&s);
    }
}

/* Every law of laws.h, or a few. */
static void maps_of_composed_laws_have_the_fates_of_their_orbits(void **state)
{
    const size_t slopes = map_slopes(0), few = 12;
    const size_t laws = slopes ? slopes * LAWS : few;
    uint64_t rng = check_seed();
    size_t maps = 0;

    (void) state;
    for (size_t i = 0; i < laws; i++) {
        const struct law law =
            laws_at(slopes ? i % LAWS : check_bits(&rng) % LAWS);
        struct slope s;
        if (!random_slope_by(&s, &law, &rng, map))
            continue;
        check_map(&s);
        slope_free(&s);
        maps++;
    }
    print_message("# CHECK_SEED=%llu: %zu maps\n",
                  (unsigned long long) check_seed(), maps);
    CHECK(2 * maps >= laws, "%zu maps of %zu laws", maps, laws);
}

/* A whole basin of it was labelled wrong by an orbit that landed in a band of
 * 1e-13. */
static void a_flat_shelf_does_not_turn_a_basin_round(void **state)
{
    struct slope s;

    (void) state;
    slope_make(&s, "spinodal", NULL, "0.32",
               ((const char *const[]){ "products=[basins]", "material.L=1e-4",
                                       "material.V_star=1e-8",
                                       "basins={cells: [32, 32], audit: 50}",
                                       "window.v=[1e-6, 1e12]", NULL }));
    struct fate_told label;
    assert_int_equal(labels_find(&s.study.basins.labels,
                                 block_offset(&s.study.slider.block, 1e9, 10.0),
                                 NULL, &label),
                     STATUS_OK);
    assert_int_equal(label.fate, FATE_SLIDING);
    check_map(&s);
    slope_free(&s);
}

/* Its cells are counted, and counted cells are near the true share. */
static void an_exact_map_prints_the_shares_of_its_cells(void **state)
{
    struct slope s;

    (void) state;
    slope_make(&s, "spinodal", NULL, "0.32",
               ((const char *const[]){ "products=[basins]",
                                       "basins={cells: [20, 10], exact: true}",
                                       "window.v=[1e-6, 1e12]", NULL }));
    const struct basin_map *m = &s.study.basins;
    int8_t label[200];
    int creeps = 0;
    assert_int_equal(basin_map_rows(m, 0, 10, label), STATUS_OK);
    for (int i = 0; i < 200; i++)
        creeps += label[i] == FATE_CREEP;
    const struct quantity share = m->fraction[FATE_CREEP].log;
    CHECK(fabs(share.value - creeps / 200.0) < 1e-12, "%.17g of %d",
          share.value, creeps);
    assert_true(share.error > 1e-6 && share.error < 0.05);
    assert_int_equal(m->audit.cells, 200);
    assert_int_equal(m->audit.disagreements, 0);
    slope_free(&s);
}

/* Between folds the separatrix moves as smoothly as the slope. */
static void shares_are_continuous_in_the_slope(void **state)
{
    double before = (double) NAN;

    (void) state;
    for (int i = 0; i < 60; i++) {
        struct slope s;
        char alpha[32];
        snprintf(alpha, sizeof alpha, "%.6g", 0.295 + 0.0014 * i);
        slope_make(
            &s, "spinodal", NULL, alpha,
            ((const char *const[]){ "products=[basins]", "material.L=1e-4",
                                    "material.V_star=1e-8",
                                    "basins={cells: [1, 1], audit: 0}",
                                    "window.v=[1e-6, 1e12]", NULL }));
        const double share = s.study.basins.fraction[FATE_CREEP].log.value;
        CHECK(isnan(before) || fabs(share - before) < 0.05,
              "alpha = %s: %g after %g", alpha, share, before);
        before = share;
        slope_free(&s);
    }
}

/* ---- one answer ---------------------------------------------------------- */

/* A run from the state never tells another fate than its side. */
static void check_run(const struct scene *c, const struct labels *l,
                      struct push_state at, int fate)
{
    const struct slider *s = l->slider;
    struct transient_options o = transient_defaults(c);
    struct transient t;

    o.labels = l;
    assert_int_equal(
        transient_find(s, (struct scene_start){ at.v, at.psi }, &o, NULL, &t),
        STATUS_OK);
    CHECK(t.sum.fate == fate,
          "%s at alpha = %.17g: v = %.17g, psi = %.17g: "
          "%s in push, %s in simulate",
          s->block.law.preset, atan((double) s->block.tan_alpha), at.v, at.psi,
          fate_names[fate], fate_names[t.sum.fate]);
    if (fate == FATE_UNDECIDED)
        CHECK(t.reason && t.sum.end == TRANSIENT_NEAR &&
                  !quantity_exists(&t.sum.time) &&
                  !quantity_exists(&t.sum.slip),
              "%s", t.reason ? t.reason : "no reason");
    transient_free(&t);
}

/* The window reaches as far to either side as a factor, or as much. */
static void zoom(struct scene *c, bool is_log, struct push_state at,
                 double width)
{
    const double part = expm1(width);

    c->window.v[0] = at.v / (1.0 + part);
    c->window.v[1] = at.v * (1.0 + part);
    c->window.psi[0] = is_log ? at.psi / (1.0 + part) : at.psi - width;
    c->window.psi[1] = is_log ? at.psi * (1.0 + part) : at.psi + width;
}

static void check_zoomed(const struct push *p, struct push_state at,
                         double width)
{
    enum { SIDE = 6 };
    struct scene c = *p->scene; /* borrows */
    struct cell cell[SIDE * SIDE];
    int8_t label[SIDE * SIDE];
    struct fault why;
    struct study s;

    zoom(&c, p->slider.plane.system.axis[1].is_log, at, width);
    if (!(c.window.psi[0] < c.window.psi[1] && c.window.v[0] < c.window.v[1]))
        return;
    c.products = 1u << PRODUCT_BASINS | 1u << PRODUCT_SLIP;
    c.cells[0] = c.cells[1] = SIDE;
    c.audit = 0;
    CHECK(study_run(&s, &c, NULL, &why) == STATUS_OK, "%s", why.text);
    const struct basin_map *m = &s.basins;
    assert_int_equal(basin_map_rows(m, 0, SIDE, label), STATUS_OK);
    assert_int_equal(fields_find(&s.fields, 0, SIDE, NULL, cell), STATUS_OK);
    for (size_t i = 0; i < SIDE * SIDE; i++) {
        struct push_answer a;
        const struct push_state here = { m->v[i % SIDE], m->psi[i / SIDE] };
        assert_int_equal(push_find(p, here, NULL, &a), STATUS_OK);
        CHECK(label[i] == a.fate && (cell[i].exit_reason == a.fate ||
                                     cell[i].exit_reason == FATE_UNDECIDED),
              "%s at alpha = %.17g: v = %.17g, psi = %.17g: %s in push, %s in "
              "a map, its orbit %s",
              p->slider.block.law.preset, c.alpha, here.v, here.psi,
              fate_names[a.fate], fate_names[label[i]],
              fate_names[cell[i].exit_reason]);
    }
    study_free(&s);
}

/* At any distance from saddle and separatrix. */
static void push_simulate_and_maps_give_one_fate(void **state)
{
    uint64_t rng = check_seed();

    (void) state;
    for (size_t i = 0; i < 2 * random_presets(); i++) {
        static const char *const set[] = { "products=[equilibria]", NULL };
        struct fault why;
        struct slope s;
        struct push p;
        random_slope_of(&s, i % random_presets(), &rng, set);
        assert_int_equal(push_init(&p, &s.scene, NULL, &why), STATUS_OK);
        assert_int_equal(push_tabulate(&p, NULL), STATUS_OK);
        for (int k = 0; k < 4; k++) {
            const struct push_state at = beside(&p.labels, &rng);
            struct push_answer a;
            assert_int_equal(push_find(&p, at, NULL, &a), STATUS_OK);
            check_run(p.scene, &p.labels, at, a.fate);
        }
        const struct push_state at = beside(&p.labels, &rng);
        check_zoomed(&p, at, pow(10.0, check_uniform(&rng, -15.0, -1.0)));
        push_free(&p);
        slope_free(&s);
    }
}

/* ---- errors -------------------------------------------------------------- */

static void every_allocation_may_fail(void **state)
{
    static const char *const set[] = { "products=[equilibria]", NULL };
    enum status status = STATUS_NO_MEMORY;
    struct slope s;
    struct labels l;
    long k = 0;

    (void) state;
    slope_make(&s, "spinodal_gen", NULL, "0.34", set);
    for (; status == STATUS_NO_MEMORY; k++) {
        fault_alloc_at(k);
        status = labels_init(&l, &s.study.slider, s.scene.rtol, NULL);
        fault_alloc_at(FAULT_ALLOC_NEVER);
        labels_free(&l);
        labels_free(&l);
    }
    assert_int_equal(status, STATUS_OK);
    CHECK(k > 8, "%ld allocations", k);
    slope_free(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(random_states_are_on_the_side_that_113_bits_say),
        cmocka_unit_test(curves_of_numbers_tell_no_other_side),
        cmocka_unit_test(at_the_saddle_nothing_is_told),
        cmocka_unit_test(random_maps_have_the_fates_of_their_orbits),
        cmocka_unit_test(maps_of_composed_laws_have_the_fates_of_their_orbits),
        cmocka_unit_test(a_flat_shelf_does_not_turn_a_basin_round),
        cmocka_unit_test(an_exact_map_prints_the_shares_of_its_cells),
        cmocka_unit_test(shares_are_continuous_in_the_slope),
        cmocka_unit_test(push_simulate_and_maps_give_one_fate),
        cmocka_unit_test(every_allocation_may_fail),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
