/* Runs of Figs 14 and 15, and what must hold of any. */
#include "fault_alloc.h"
#include "followed.h"
#include "sample.h"
#include "stops.h"

static void make(struct slope *s, const char *law)
{
    slope_make(s, law, NULL, "0.34",
               (const char *const[]){ "products=[knees]", NULL });
}

/* From the start of Figs 14 and 15, or another; limits 0: none. */
static struct transient run(const struct slope *s, double v, double psi,
                            double until_time, double until_slip)
{
    struct transient_options o = transient_defaults(&s->scene);

    o.until_time = until_time;
    o.until_slip = until_slip;
    return follow(s, v, psi, &o);
}

static void is_quantity(const struct quantity *q, double expected, double far)
{
    CHECK(quantity_exists(q) && fabs(q->value - expected) <= far,
          "%.17g, expected %.17g: %s", q->value, expected,
          q->reason ? q->reason : "");
}

static void the_block_of_fig_14_rests_when_the_reference_says(void **state)
{
    struct slope s;

    (void) state;
    make(&s, "dieterich_gen");
    struct transient t = run(&s, pow(10, 3.1), 100, 0, 0);
    const double time = 0.8417232056933424, slip = 0.4942932325338876;
    assert_int_equal(t.sum.fate, FATE_REST_FINITE);
    assert_int_equal(t.sum.end, TRANSIENT_REST);
    is_quantity(&t.sum.time, time, t.sum.time.error);
    is_quantity(&t.sum.slip, slip, t.sum.slip.error);
    is_quantity(&t.sum.time, time, 1e-12);
    is_quantity(&t.sum.slip, slip, 1e-12);
    const struct transient_event *last = &t.event[t.events - 1];
    assert_int_equal(last->what, MOMENT_REST);
    is_quantity(&last->time, time, 1e-12);
    is_quantity(&last->v, 0, 0);
    transient_free(&t);
    slope_free(&s);
}

/* Sec. 4.4 reads 0.325 and 0.494 off Fig 14(a). */
static void the_phases_of_fig_14_are_those_of_the_paper(void **state)
{
    struct slope s;

    (void) state;
    make(&s, "dieterich_gen");
    struct transient t = run(&s, pow(10, 3.1), 100, 0, 0);
    is_quantity(&t.phase[0].start_slip, 0, 0);
    is_quantity(&t.phase[0].end_slip, 0.325, 5e-4);
    is_quantity(&t.phase[1].start_slip, t.phase[0].end_slip.value, 0);
    is_quantity(&t.phase[1].end_slip, 0.494, 5e-4);
    is_quantity(&t.phase[2].start_time, t.phase[1].end_time.value, 0);
    is_quantity(&t.phase[2].end_time, t.sum.time.value, 0);
    transient_free(&t);
    slope_free(&s);
}

static void without_v_minus_there_is_no_third_phase(void **state)
{
    struct slope s;

    (void) state;
    make(&s, "spinodal");
    struct transient t = run(&s, 1e2, 2, 0, 0);
    assert_int_equal(t.sum.end, TRANSIENT_ARREST);
    assert_true(quantity_exists(&t.phase[1].end_time));
    assert_false(quantity_exists(&t.phase[2].start_time));
    transient_free(&t);
    slope_free(&s);
}

static void a_start_below_v_minus_is_in_the_third_phase(void **state)
{
    struct slope s;

    (void) state;
    make(&s, "dieterich_gen");
    struct transient t = run(&s, 1e-3, 10, 0, 0);
    assert_int_equal(t.sum.end, TRANSIENT_REST);
    assert_false(quantity_exists(&t.phase[0].start_time));
    assert_false(quantity_exists(&t.phase[1].start_time));
    is_quantity(&t.phase[2].start_time, 0, 0);
    transient_free(&t);
    slope_free(&s);
}

/* Rates there are rounding, and change sign hundreds of times. */
static void nothing_turns_where_the_block_only_creeps(void **state)
{
    struct slope s;
    int turns[MOMENTS] = { 0 };

    (void) state;
    make(&s, "spinodal_gen");
    struct transient t = run(&s, pow(10, 3.1), 100, 1e6, 0);
    for (size_t i = 0; i < t.events; i++)
        turns[t.event[i].what]++;
    assert_int_equal(turns[MOMENT_PSI_MIN], 1);
    assert_int_equal(turns[MOMENT_MU_MIN], 1);
    assert_int_equal(turns[MOMENT_MU_MAX], 1);
    assert_int_equal(
        turns[MOMENT_PSI_MAX] + turns[MOMENT_V_MIN] + turns[MOMENT_V_MAX], 0);
    assert_int_equal(turns[MOMENT_ARREST], 1);
    assert_int_equal(t.sum.end, TRANSIENT_UNTIL_TIME);
    transient_free(&t);
    slope_free(&s);
}

static void every_law_keeps_the_balance_of_energy(void **state)
{
    static const char *const law[] = { "dieterich",       "dieterich_gen",
                                       "ruina",           "perrin",
                                       "spinodal",        "spinodal_gen",
                                       "spinodal_phi_gen" };
    uint64_t seed = check_seed();

    (void) state;
    for (int i = 0; i < 7; i++) {
        struct slope s;
        make(&s, law[i]);
        for (int k = 0; k < 3; k++) {
            const double v = exp(check_uniform(&seed, -3, 8));
            const double psi = exp(check_uniform(&seed, -2, 2));
            struct transient t = run(&s, v, psi, 0, 0);
            CHECK(t.sum.end != TRANSIENT_LOST && t.curve.count > 0,
                  "%s from (%g, %g)", law[i], v, psi);
            CHECK(fabs(t.sum.energy_defect) <= 1e-10, "%s from (%g, %g): %g",
                  law[i], v, psi, t.sum.energy_defect);
            transient_free(&t);
        }
        slope_free(&s);
    }
}

static void runs_end_where_they_are_told(void **state)
{
    struct slope s;

    (void) state;
    make(&s, "dieterich_gen");
    struct transient t = run(&s, pow(10, 3.1), 100, 0.1, 0);
    assert_int_equal(t.sum.end, TRANSIENT_UNTIL_TIME);
    is_quantity(&t.sum.time, 0.1, 1e-15);
    transient_free(&t);
    t = run(&s, pow(10, 3.1), 100, 0, 0.25);
    assert_int_equal(t.sum.end, TRANSIENT_UNTIL_SLIP);
    is_quantity(&t.sum.slip, 0.25, 1e-15);
    assert_int_equal(t.sum.fate, FATE_REST_FINITE);
    transient_free(&t);
    t = run(&s, 4e3, 10, 0, 0);
    assert_int_equal(t.sum.end, TRANSIENT_RUNAWAY);
    assert_int_equal(t.sum.fate, FATE_RUNAWAY);
    assert_string_equal(t.sum.slip.reason, fate_runs_away);
    assert_string_equal(t.sum.time.reason, fate_runs_away);
    assert_string_equal(t.sum.mu_mean.reason, fate_runs_away);
    transient_free(&t);
    t = run(&s, 4e3, 10, 0, 100);
    assert_int_equal(t.sum.fate, FATE_RUNAWAY);
    is_quantity(&t.sum.slip, 100, 1e-13);
    transient_free(&t);
    slope_free(&s);
}

static void slow_orbits_are_followed_far(void **state)
{
    struct slope s;

    (void) state;
    make(&s, "dieterich");
    struct transient t = run(&s, 1, 2, 0, 0);
    assert_int_equal(t.sum.end, TRANSIENT_FADED);
    assert_int_equal(t.sum.fate, FATE_REST_ASYMPTOTIC);
    assert_true(quantity_exists(&t.sum.slip) &&
                quantity_exists(&t.sum.mu_mean));
    assert_string_equal(t.sum.time.reason, "the block never quite stops");
    assert_true(t.phase[1].end_slip.value == t.sum.slip.value);
    transient_free(&t);
    slope_free(&s);
    make(&s, "ruina");
    t = run(&s, 1000, 1, 0, 0);
    assert_int_equal(t.sum.end, TRANSIENT_FADED);
    assert_string_equal(t.sum.time.reason, "the block never quite stops");
    assert_string_equal(t.sum.slip.reason, "the slip grows without bound");
    assert_false(quantity_exists(&t.sum.mu_mean));
    transient_free(&t);
    slope_free(&s);
}

/* The limit is known only far below where v has fallen by eight powers of ten;
 * it is what push tells. */
static void a_fading_run_is_followed_down_to_its_limit(void **state)
{
    struct slope s;

    (void) state;
    slope_make(&s, "dieterich", "log", "0.35645503446508281",
               (const char *const[]){ "products=[knees]", "material.a=0.004643",
                                      "material.b=0.0257", NULL });
    struct transient t = run(&s, 0.12353272237968428, 12016.116354857193, 0, 0);
    assert_int_equal(t.sum.end, TRANSIENT_FADED);
    is_quantity(&t.sum.slip, 4.08029649012904e-9, 1e-22);
    is_quantity(&t.sum.mu_mean, 0.598370380009248, 1e-14);
    transient_free(&t);
    slope_free(&s);
}

/* 113 bits. */
static void a_loose_run_that_fades_has_the_limit_of_a_fine_one(void **state)
{
    struct slope s;

    (void) state;
    slope_make(&s, "dieterich", NULL, "0.09528374374425069",
               (const char *const[]){
                   "products=[equilibria]", "material.a=0.0015099802368807108",
                   "material.b=0.0019337108043160614",
                   "material.L=2.3303960631004794e-07",
                   "material.V_star=6.51499493974773e-08", NULL });
    struct transient_options o = transient_defaults(&s.scene);
    o.rtol = 1e-6;
    struct transient t =
        follow(&s, 0.00011562161277781637, 1.4331350146638147e-07, &o);
    assert_int_equal(t.sum.end, TRANSIENT_FADED);
    is_quantity(&t.sum.slip, 5.4556712001839188e-17, t.sum.slip.error);
    transient_free(&t);
    slope_free(&s);
}

/* Its psi moves by e^(-1/v): v settles within an instant, and time is all that
 * goes on. */
static void a_block_that_waits_for_ever_is_soon_told(void **state)
{
    struct slope s;

    (void) state;
    slope_make(&s, "dieterich", NULL, "0.34",
               (const char *const[]){
                   "products=[knees]", "law.theta=ln_psi", "law.psi_ss=inverse",
                   "law.timescale=slip45", "law.kinetics=linear", NULL });
    struct transient t = run(&s, 1e-3, 1e5, 0, 0);
    assert_int_equal(t.sum.end, TRANSIENT_LOST);
    assert_string_equal(t.reason, "it takes longer than any number holds");
    CHECK(t.sum.field_evaluations < 100000, "%lld evaluations",
          (long long) t.sum.field_evaluations);
    transient_free(&t);
    slope_free(&s);
}

static void a_start_at_a_node_goes_nowhere(void **state)
{
    struct slope s;

    (void) state;
    make(&s, "spinodal_gen");
    struct transient t = run(&s, 0.0011727063018, 90.39886780, 0, 0);
    assert_int_equal(t.sum.end, TRANSIENT_ARREST);
    assert_int_equal(t.sum.fate, FATE_CREEP);
    assert_int_equal(t.curve.count, 0);
    assert_false(quantity_exists(&t.phase[0].start_time));
    is_quantity(&t.sum.slip, 0, 0);
    transient_free(&t);
    t = run(&s, 0.0011727063018, 90.39886780, 10, 0);
    assert_int_equal(t.sum.end, TRANSIENT_UNTIL_TIME);
    is_quantity(&t.sum.slip, 0.011727063018, 1e-9);
    transient_free(&t);
    slope_free(&s);
}

static void samples_are_evenly_spaced_and_on_the_orbit(void **state)
{
    enum { N = 50 };
    struct trajectory_row by_slip[N], by_time[N];
    struct slope s;

    (void) state;
    make(&s, "dieterich_gen");
    struct transient t = run(&s, pow(10, 3.1), 100, 0, 0);
    sample_linear_slip(&s.study.slider, &t, N, by_slip);
    sample_log_time(&s.study.slider, &t, N, by_time);
    const double ratio = by_time[1].time / by_time[0].time;
    for (int i = 0; i + 1 < N; i++) {
        CHECK(fabs(by_slip[i + 1].slip - by_slip[i].slip -
                   t.sum.slip.value / (N - 1)) < 1e-12,
              "%d", i);
        CHECK(fabs(by_time[i + 1].time / by_time[i].time / ratio - 1) < 1e-9,
              "%d", i);
        const struct trajectory_row at =
            sample_at_time(&s.study.slider, &t, by_slip[i].time);
        CHECK(fabs(at.slip - by_slip[i].slip) < 1e-12, "%d: %.17g, %.17g", i,
              at.slip, by_slip[i].slip);
    }
    CHECK(by_slip[0].time == 0 && by_slip[0].slip == 0, "%g", by_slip[0].time);
    CHECK(fabs(by_time[N - 1].time - t.sum.time.value) < 1e-12, "%g",
          by_time[N - 1].time);
    CHECK(by_time[0].time < 1e-40, "%g", by_time[0].time);
    transient_free(&t);
    slope_free(&s);
}

static void starts_outside_the_domain_are_refused(void **state)
{
    struct slope s;
    struct transient t;

    (void) state;
    make(&s, "perrin");
    const struct transient_options o = transient_defaults(&s.scene);
    assert_int_equal(transient_find(&s.study.slider,
                                    (struct scene_start){ 1, 800 }, &o, NULL,
                                    &t),
                     STATUS_BAD_ARGUMENT);
    transient_free(&t);
    slope_free(&s);
}

static void a_monitor_stops_a_run(void **state)
{
    const struct monitor monitor = { .tell = stop_at_once };
    struct slope s;
    struct transient t;

    (void) state;
    make(&s, "dieterich_gen");
    const struct transient_options o = transient_defaults(&s.scene);
    assert_int_equal(transient_find(&s.study.slider,
                                    (struct scene_start){ 1e3, 10 }, &o,
                                    &monitor, &t),
                     STATUS_STOPPED);
    slope_free(&s);
}

static void every_failing_allocation_is_reported(void **state)
{
    struct slope s;
    struct transient t;
    enum status status = STATUS_NO_MEMORY;
    long k;

    (void) state;
    make(&s, "dieterich_gen");
    struct transient_options o = transient_defaults(&s.scene);
    o.rtol = 1e-7;
    for (k = 0; status == STATUS_NO_MEMORY; k++) {
        fault_alloc_at(k);
        status = transient_find(&s.study.slider,
                                (struct scene_start){ 1e3, 10 }, &o, NULL, &t);
    }
    fault_alloc_at(FAULT_ALLOC_NEVER);
    assert_int_equal(status, STATUS_OK);
    CHECK(k > 6, "%ld allocations", k);
    transient_free(&t);
    slope_free(&s);
}

/* While v waits d = psi - psi_ss falls by (26): tanh(d/2) by e^(-t/T). */
static void samples_of_a_leap_are_right(void **state)
{
    enum { N = 201 };
    const double psi[] = { 700.0, 760.0, 1e5 };
    struct trajectory_row row[N];
    struct slope s;

    (void) state;
    make(&s, "dieterich_gen");
    for (int k = 0; k < 3; k++) {
        struct transient t = run(&s, 1.0, psi[k], 0, 0);
        int early = 0;
        sample_log_time(&s.study.slider, &t, N, row);
        for (int i = 0; i < N; i++) {
            const struct trajectory_row *r = &row[i];
            assert_true(r->time > 0.0 && isfinite(r->time));
            assert_true(isfinite(r->v) && isfinite(r->psi) &&
                        isfinite(r->slip) && isfinite(r->mu));
            assert_true(i == 0 || r->time > row[i - 1].time);
            if (r->time > 1e-18)
                continue;
            const double u = 2.0 * exp(1.0 - psi[k]) + r->time;
            const double d = r->psi - 1.0;
            CHECK(fabs(d + log(0.5 * u)) < 1e-8 * d, "%g, %g: %.16g, not %.16g",
                  psi[k], r->time, d, -log(0.5 * u));
            early++;
        }
        CHECK(early > 100, "%d", early);
        transient_free(&t);
    }
    slope_free(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_block_of_fig_14_rests_when_the_reference_says),
        cmocka_unit_test(the_phases_of_fig_14_are_those_of_the_paper),
        cmocka_unit_test(without_v_minus_there_is_no_third_phase),
        cmocka_unit_test(a_start_below_v_minus_is_in_the_third_phase),
        cmocka_unit_test(nothing_turns_where_the_block_only_creeps),
        cmocka_unit_test(every_law_keeps_the_balance_of_energy),
        cmocka_unit_test(runs_end_where_they_are_told),
        cmocka_unit_test(slow_orbits_are_followed_far),
        cmocka_unit_test(a_fading_run_is_followed_down_to_its_limit),
        cmocka_unit_test(a_loose_run_that_fades_has_the_limit_of_a_fine_one),
        cmocka_unit_test(a_block_that_waits_for_ever_is_soon_told),
        cmocka_unit_test(a_start_at_a_node_goes_nowhere),
        cmocka_unit_test(samples_are_evenly_spaced_and_on_the_orbit),
        cmocka_unit_test(samples_of_a_leap_are_right),
        cmocka_unit_test(starts_outside_the_domain_are_refused),
        cmocka_unit_test(a_monitor_stops_a_run),
        cmocka_unit_test(every_failing_allocation_is_reported),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
