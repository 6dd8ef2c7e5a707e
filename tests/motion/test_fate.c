/* What becomes of states, how far and how long they slide. */
#include "fate.h"

#include "fault_alloc.h"
#include "found.h"
#include "slope.h"
#include "stops.h"
#include "tolerance.h"

static const char *const steady_only[] = { "products=[equilibria]", NULL };

static struct fate_result find(const struct slope *s, struct vec2 z,
                               double rtol)
{
    struct fate_result r;
    const enum status status =
        fate_find(&s->study.slider, z, rtol, true, NULL, &r);

    CHECK(status == STATUS_OK, "%s", status_text(status));
    CHECK((r.reason != NULL) == (r.fate == FATE_UNDECIDED), "%s: %s",
          fate_names[r.fate], r.reason ? r.reason : "no reason");
    return r;
}

/* The fate of one state of a law at a slope. */
static enum fate fate_at(const char *law, const char *alpha, double v,
                         double psi)
{
    struct slope s;

    slope_make(&s, law, NULL, alpha, steady_only);
    const struct fate_result r = find(&s, slope_point(&s, v, psi), 1e-8);
    const struct fate_result coarse = find(&s, slope_point(&s, v, psi), 1e-5);
    CHECK(r.fate == coarse.fate, "%s: %s and %s", law, fate_names[r.fate],
          fate_names[coarse.fate]);
    slope_free(&s);
    return r.fate;
}

#define IS(law, alpha, v, psi, expected)                                       \
    do {                                                                       \
        const enum fate found_ = fate_at(law, alpha, v, psi);                  \
        CHECK(found_ == (expected), "%s at %s, (%g, %g): %s", law, alpha,      \
              (double) (v), (double) (psi), fate_names[found_]);               \
    } while (0)

/* ---- fates --------------------------------------------------------------- */

static void check_row(struct slope *s, const struct csv *c)
{
    const struct fate_result r = find(s, row_point(s, c), 1e-10);

    CHECK((int) r.fate == row_fate(c), "row %zu: %s", c->row,
          fate_names[r.fate]);
}

static void every_reference_state_has_its_fate(void **state)
{
    (void) state;
    const int rows = each_basin_row(1e-6, steady_only, check_row);
    CHECK(rows >= 440, "%d rows", rows);
}

static void a_saddle_parts_rest_from_running_away(void **state)
{
    (void) state;
    IS("dieterich_gen", "0.34", 1e3, 10, FATE_REST_FINITE);
    IS("dieterich_gen", "0.34", 3e3, 10, FATE_RUNAWAY);
    IS("dieterich", "0.34", 1e4, 2, FATE_RUNAWAY);
    IS("perrin", "0.34", 1e3, 2, FATE_RUNAWAY);
    IS("ruina", "0.34", 1e4, 2, FATE_RUNAWAY);
}

static void a_saddle_parts_the_creep_node_from_the_sliding_one(void **state)
{
    (void) state;
    IS("spinodal", "0.34", 1e3, 2, FATE_CREEP);
    IS("spinodal", "0.34", 4e3, 2, FATE_SLIDING);
    IS("spinodal_phi_gen", "0.34", 1e-5, 0.01, FATE_CREEP);
    IS("spinodal_phi_gen", "0.34", 3, 0.001, FATE_SLIDING);
}

static void without_a_saddle_all_go_the_same_way(void **state)
{
    (void) state;
    for (double v = 1e-5; v < 1e6; v *= 30.0) {
        IS("spinodal_gen", "0.2", v, 1.0, FATE_CREEP);
        IS("spinodal_gen", "0.45", v, 1.0, FATE_SLIDING);
    }
}

/* Orbits from there leave the doubles, some within times that are no normal
 * numbers, or follow the slow curve where rates are e^700 apart. */
static void without_a_saddle_no_state_is_undecided(void **state)
{
    static const double from[][2] = {
        { -295, 120 }, { -295, 290 }, { -299.9, 299 }, { -299.99, 290.5 }
    };
    struct slope s;

    (void) state;
    slope_make(&s, "spinodal", NULL, "0.42", steady_only);
    for (size_t i = 0; i < sizeof from / sizeof *from; i++)
        for (double rtol = 1e-3; rtol > 1e-9; rtol *= 0.1) {
            const struct vec2 z = { from[i][0] * log(10.0),
                                    from[i][1] * log(10.0) };
            struct fate_result r;
            assert_int_equal(
                fate_find(&s.study.slider, z, rtol, false, NULL, &r),
                STATUS_OK);
            CHECK(r.fate == FATE_SLIDING && r.reason == NULL, "%zu, %g: %s", i,
                  rtol, fate_names[r.fate]);
        }
    slope_free(&s);
}

/* v -> 0 like a power of time. */
static void creep_without_a_node_is_no_rest_in_finite_time(void **state)
{
    (void) state;
    IS("dieterich", "0.34", 1.0, 2.0, FATE_REST_ASYMPTOTIC);
    IS("ruina", "0.34", 1.0, 2.0, FATE_REST_ASYMPTOTIC);
    IS("perrin", "0.34", 1.0, 2.0, FATE_REST_ASYMPTOTIC);
    IS("dieterich", "0.34", 7e-3, 7500.0, FATE_REST_ASYMPTOTIC);
    IS("perrin", "0.34", 1e-3, 9.0, FATE_REST_ASYMPTOTIC);
}

/* psi rises there at a rate of e^1000 and more, which no double holds. */
static void states_far_below_psi_ss_rest_no_sooner_than_v_can_fall(void **state)
{
    struct slope s;

    (void) state;
    slope_make(&s, "dieterich_gen", NULL, "0.34", steady_only);
    for (double v = 1e-5; v < 0.02; v *= 3.0) {
        const struct fate_result r = find(&s, slope_point(&s, v, 0.01), 1e-7);
        CHECK(r.fate == FATE_REST_FINITE, "v = %g: %s", v, fate_names[r.fate]);
        const double soonest =
            material_eps2(&s.study.slider.block.material) * v;
        CHECK(r.time.value > soonest, "v = %g: %g < %g", v, r.time.value,
              soonest);
    }
    slope_free(&s);
}

/* ---- slip, time, friction ------------------------------------------------ */

/* eps^2 v^2/2 = work cos(alpha) - slip sin(alpha), (27), down to v = 0. */
static void check_energy(const struct slope *s, double v,
                         const struct fate_result *r)
{
    const double alpha = s->scene.alpha;
    const double eps2 = material_eps2(&s->study.slider.block.material);
    const double mean =
        tan(alpha) + eps2 * v * v / (2.0 * cos(alpha) * r->slip.value);

    CHECK(fabs(r->mu_mean.value - mean) <= 1e-7 * mean, "%.12g, not %.12g",
          r->mu_mean.value, mean);
}

static void the_energy_lost_is_the_work_of_friction(void **state)
{
    struct slope s;

    (void) state;
    slope_make(&s, "dieterich_gen", NULL, "0.34", steady_only);
    for (double v = 1e-5; v < 3e3; v *= 10.0) {
        const struct fate_result r = find(&s, slope_point(&s, v, 10.0), 1e-9);
        CHECK(r.fate == FATE_REST_FINITE, "v = %g: %s", v, fate_names[r.fate]);
        check_energy(&s, v, &r);
    }
    slope_free(&s);
}

/* The last rows of transient.csv are at v = 1e-10. */
static void a_rest_comes_when_the_table_says(void **state)
{
    struct csv c;
    int rests = 0;

    (void) state;
    csv_open(&c, "transient.csv");
    while (csv_next(&c)) {
        struct slope s;
        if (strcmp(csv_text(&c, "kind"), "v_equals_final") != 0 ||
            csv_number(&c, "key", 1.0) > 1e-9)
            continue;
        slope_make(&s, csv_text(&c, "law"), csv_text(&c, "form"),
                   csv_text(&c, "alpha"), steady_only);
        const double v = pow(10.0, 3.1);
        const struct fate_result r = find(&s, slope_point(&s, v, 100.0), 1e-11);
        const double t = csv_number(&c, "t", 0), x = csv_number(&c, "x", 0);
        CHECK(r.fate == FATE_REST_FINITE, "%s", fate_names[r.fate]);
        CHECK(fabs(r.time.value - t) <= r.time.error, "%.16g +- %g, not %.16g",
              r.time.value, r.time.error, t);
        CHECK(r.time.error < 1e-9 * t, "%g", r.time.error);
        CHECK(fabs(r.slip.value - x) < 1e-10, "%.16g, not %.16g", r.slip.value,
              x);
        check_energy(&s, v, &r);
        slope_free(&s);
        rests++;
    }
    assert_int_equal(rests, 2);
}

static void a_creep_node_is_reached_when_the_table_says(void **state)
{
    struct slope s;

    (void) state;
    slope_make(&s, "spinodal_gen", "asinh", "0.34", steady_only);
    const struct fate_result r =
        find(&s, slope_point(&s, pow(10.0, 3.1), 100.0), 1e-10);
    /* the rows v = 0.01 and psi = 90: 215 % and 0.4 % from the node */
    CHECK(r.time.value > 1.0350825 && r.time.value < 188.67, "%g",
          r.time.value);
    CHECK(r.slip.value > 0.524527 && r.slip.value < 0.749535, "%g",
          r.slip.value);
    slope_free(&s);
}

/* How far off a looser orbit's slip is. */
static double looser_slip(const struct scene *scene, long double tan_alpha,
                          struct vec2 z, double rtol, struct fate_result *fine,
                          struct fate_result *loose)
{
    struct slider s;

    slider_init(&s, &scene->law, &scene->material, tan_alpha);
    assert_int_equal(fate_find(&s, z, 1e-12, true, NULL, fine), 0);
    assert_int_equal(fate_find(&s, z, rtol, true, NULL, loose), 0);
    return fabs(loose->slip.value - fine->slip.value);
}

/* Past a saddle that v leaves a thousandfold, slip by the lateness there. */
static void a_single_orbit_is_no_further_off_than_its_bar(void **state)
{
    static const struct found f = {
        FRICTION_LOG,           THETA_PSI,
        PSI_SS_SPINODAL,        TIMESCALE_AGEING44,
        KINETICS_SINH,          0.6877345343190937,
        0.039329336430911181,   0.13321146233862499,
        1.1057293844243979e-06, 538513.82719759853,
        1.0832174286574756e-07, 9.1188336730034283e-06,
        0.8405281862,           1e-6
    };
    const struct vec2 z = { -1.2807363725941099, 3.5992717819910207 };
    struct fate_result fine, loose;
    struct scene scene;

    (void) state;
    found_scene(&f, steady_only, &scene);
    const double off =
        looser_slip(&scene, 1.11682828029965442276L, z, 1e-7, &fine, &loose);
    CHECK(off > 1e-6 * fine.slip.value && off <= loose.slip.error, "%g over %g",
          off, loose.slip.error);
    scene_free(&scene);
}

/* The polynomial of the step that goes into the box of arrest is 2000 times
 * further off inside the step than at its end, but crosses the true orbit. */
static void an_orbit_ends_at_the_end_of_a_step(void **state)
{
    const struct vec2 z = { -12.30443909068693, 0.03125 };
    struct fate_result fine, loose;
    struct scene scene;

    (void) state;
    slope_scene(&scene, "perrin", "asinh", "0.407864", steady_only);
    scene.material.b = 0.0342615;
    const double off =
        looser_slip(&scene, scene.tan_alpha, z, 3.56e-7, &fine, &loose);
    CHECK(off <= loose.slip.error && off < 1e-8 * fine.slip.value,
          "%g over %g of %g", off, loose.slip.error, fine.slip.value);
    scene_free(&scene);
}

/* The step away from the saddle is a factor of 22 long: what is off on it all
 * but cancels between its ends. */
static void a_long_step_is_no_further_off_than_its_bar(void **state)
{
    static const struct found f = { FRICTION_LOG,
                                    THETA_LN_PSI,
                                    PSI_SS_INVERSE,
                                    TIMESCALE_SLIP,
                                    KINETICS_LINEAR,
                                    0.369,
                                    0.030360493155306822,
                                    0.0489,
                                    0.00011093377628493074,
                                    283.3840119741688,
                                    7.6622466375976848e-06,
                                    1e-6,
                                    0.494,
                                    1e-6 };
    const struct vec2 z = { -9.0908428202773788, 9.122197218042599 };
    struct fate_result fine, loose;
    struct scene scene;

    (void) state;
    found_scene(&f, steady_only, &scene);
    const double off =
        looser_slip(&scene, 0.538108777585805432954L, z, 1e-4, &fine, &loose);
    CHECK(off <= loose.slip.error && loose.slip.error < 10.0 * off,
          "%g over %g", off, loose.slip.error);
    scene_free(&scene);
}

static void what_does_not_stop_has_neither_slip_nor_time(void **state)
{
    struct slope s;

    (void) state;
    slope_make(&s, "dieterich_gen", NULL, "0.34", steady_only);
    const struct fate_result r = find(&s, slope_point(&s, 1e4, 10.0), 1e-8);
    assert_int_equal(r.fate, FATE_RUNAWAY);
    assert_string_equal(r.slip.reason, "the block runs away");
    assert_false(quantity_exists(&r.time) || quantity_exists(&r.mu_mean));
    slope_free(&s);
}

/* ---- errors -------------------------------------------------------------- */

static void states_outside_the_domain_are_refused(void **state)
{
    const struct vec2 outside[] = { { 700.0, 0.0 },
                                    { 0.0, -700.0 },
                                    { NAN, 0.0 } };
    struct fate_result r;
    struct slope s;

    (void) state;
    slope_make(&s, "spinodal_gen", NULL, "0.34", steady_only);
    for (int i = 0; i < 3; i++)
        assert_int_equal(
            fate_find(&s.study.slider, outside[i], 1e-8, true, NULL, &r),
            STATUS_BAD_ARGUMENT);
    slope_free(&s);
}

static void a_monitor_stops_a_long_orbit(void **state)
{
    const struct monitor monitor = { stop_at_once, NULL };
    struct fate_result r;
    struct slope s;

    (void) state;
    slope_make(&s, "dieterich_gen", NULL, "0.34", steady_only);
    assert_int_equal(fate_find(&s.study.slider, slope_point(&s, 1e3, 10.0),
                               1e-12, true, &monitor, &r),
                     STATUS_STOPPED);
    slope_free(&s);
}

static void every_allocation_may_fail(void **state)
{
    enum status status = STATUS_NO_MEMORY;
    struct fate_result r;
    struct slope s;
    long k = 0;

    (void) state;
    slope_make(&s, "spinodal_gen", NULL, "0.34", steady_only);
    const struct vec2 z = slope_point(&s, 1e3, 10.0);
    for (; status == STATUS_NO_MEMORY; k++) {
        fault_alloc_at(k);
        status = fate_find(&s.study.slider, z, 1e-5, true, NULL, &r);
    }
    fault_alloc_at(FAULT_ALLOC_NEVER);
    assert_int_equal(status, STATUS_OK);
    CHECK(k > 3, "%ld allocations", k);
    slope_free(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_reference_state_has_its_fate),
        cmocka_unit_test(a_saddle_parts_rest_from_running_away),
        cmocka_unit_test(a_saddle_parts_the_creep_node_from_the_sliding_one),
        cmocka_unit_test(without_a_saddle_all_go_the_same_way),
        cmocka_unit_test(without_a_saddle_no_state_is_undecided),
        cmocka_unit_test(creep_without_a_node_is_no_rest_in_finite_time),
        cmocka_unit_test(
            states_far_below_psi_ss_rest_no_sooner_than_v_can_fall),
        cmocka_unit_test(the_energy_lost_is_the_work_of_friction),
        cmocka_unit_test(a_rest_comes_when_the_table_says),
        cmocka_unit_test(a_creep_node_is_reached_when_the_table_says),
        cmocka_unit_test(a_single_orbit_is_no_further_off_than_its_bar),
        cmocka_unit_test(an_orbit_ends_at_the_end_of_a_step),
        cmocka_unit_test(a_long_step_is_no_further_off_than_its_bar),
        cmocka_unit_test(what_does_not_stop_has_neither_slip_nor_time),
        cmocka_unit_test(states_outside_the_domain_are_refused),
        cmocka_unit_test(a_monitor_stops_a_long_orbit),
        cmocka_unit_test(every_allocation_may_fail),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
