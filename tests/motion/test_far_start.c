/* Runs from where rates are as far apart as doubles are. */
#include "followed.h"
#include "laws.h"

/* Of a law of four parts at a slope. */
static void make(struct slope *s, const char *const part[4], const char *alpha)
{
    static const char *const key[] = { "theta", "psi_ss", "timescale",
                                       "kinetics" };
    char text[6][40] = { "products=[knees]" }, *set[6];
    struct fault why;

    for (int i = 0; i < 4; i++)
        snprintf(text[1 + i], sizeof text[0], "law.%s=%s", key[i], part[i]);
    snprintf(text[5], sizeof text[0], "slope.alpha=%s", alpha);
    for (int i = 0; i < 6; i++)
        set[i] = text[i];
    assert_int_equal(scene_read(&s->scene, NULL, set, 6, &why), STATUS_OK);
    assert_int_equal(study_run(&s->study, &s->scene, NULL, &why), STATUS_OK);
}

/* psi leaps by a sinh of some 1/v, in times from 1e-300 on; then follows 1/v
 * faster than anything else, known to a rounding of ln psi, times 1/v. */
static void starts_below_all_slow_curves_are_followed(void **state)
{
    static const char *const law[][4] = {
        { "ln_psi", "inverse", "slip", "sinh" },
        { "ln_c_psi", "inverse", "spinodal", "sinh" },
        { "ln_c_1pR_psi", "inverse", "ageing44", "sinh" }
    };
    enum { KINDS = sizeof law / sizeof *law, STARTS = 3 };
    uint64_t rng = check_seed();
    struct slope s;

    (void) state;
    for (int i = 0; i < KINDS; i++) {
        make(&s, law[i], "0.346");
        const struct transient_options o = transient_defaults(&s.scene);
        for (int k = 0; k < STARTS; k++) {
            const double v = k ? laws_power(&rng, -10, -6) : 1.71e-8;
            const double psi = k ? check_uniform(&rng, 0.1, 10) : 6.3137;
            struct transient t = follow(&s, v, psi, &o);
            CHECK(t.sum.end == TRANSIENT_REST &&
                      t.sum.time.error < 1e-14 / v * t.sum.time.value,
                  "%s %s v %.17g psi %.17g: %s, %g +- %g", law[i][0], law[i][2],
                  v, psi, transient_end_names[t.sum.end], t.sum.time.value,
                  t.sum.time.error);
            transient_free(&t);
        }
        slope_free(&s);
    }
}

/* Friction slows it down, mu = m + n ln v: in a time of v eps^2 cos(alpha) over
 * mu - tan(alpha), so v/t is a line in ln v.  Beyond 1e155 rates are further
 * apart than doubles: that is told at once. */
static void starts_at_any_v_end_in_bounded_work(void **state)
{
    double rate[3];
    struct slope s;

    (void) state;
    slope_make(&s, "spinodal_phi_gen", NULL, "0.34",
               (const char *const[]){ "products=[knees]", NULL });
    struct transient_options o = transient_defaults(&s.scene);
    o.rtol = 1e-6;
    for (int i = 0; i < 3; i++) {
        const double v = pow(10, 90 + 30 * i);
        struct transient t = follow(&s, v, 1, &o);
        CHECK(t.sum.end == TRANSIENT_ARREST, "%g: %s", v, t.reason);
        rate[i] = v / t.sum.time.value;
        struct fate_result r;
        assert_int_equal(fate_find(&s.study.slider, (struct vec2){ log(v), 0 },
                                   1e-9, true, NULL, &r),
                         STATUS_OK);
        CHECK(quantity_exists(&r.time) &&
                  fabs(r.time.value - t.sum.time.value) <=
                      r.time.error + t.sum.time.error,
              "%g: %g and %g: %s", v, r.time.value, t.sum.time.value,
              r.time.reason);
        transient_free(&t);
    }
    CHECK(fabs(rate[2] - 2 * rate[1] + rate[0]) < 1e-3 * (rate[2] - rate[1]),
          "%.12g %.12g %.12g", rate[0], rate[1], rate[2]);
    for (int i = 0; i < 3; i++) {
        struct transient t = follow(&s, pow(10, 200 + 50 * i), 1, &o);
        CHECK(t.sum.end == TRANSIENT_LOST && t.reason, "%d: ends", i);
        CHECK(t.sum.field_evaluations < 100000, "%d: %lld", i,
              (long long) t.sum.field_evaluations);
        transient_free(&t);
    }
    slope_free(&s);
}

/* mu = mu0 + (mu - mu0), and next to nothing: its work is rounding. */
static void friction_that_is_nothing_costs_no_steps(void **state)
{
    static const char *const law[] = { "ln_psi", "spinodal", "spinodal",
                                       "sinh" };
    struct slope s;

    (void) state;
    make(&s, law, "0.3685");
    const struct transient_options o = transient_defaults(&s.scene);
    struct transient t = follow(&s, 1.85e-12, 0.387, &o);
    assert_int_equal(t.sum.end, TRANSIENT_ARREST);
    CHECK(t.sum.field_evaluations < 100000, "%lld",
          (long long) t.sum.field_evaluations);
    transient_free(&t);
    slope_free(&s);
}

/* It is slow for so short that where it comes from hardly matters. */
static void a_block_that_rose_from_far_below_fades_where_others_do(void **state)
{
    struct slope s;

    (void) state;
    slope_make(&s, "dieterich", NULL, "0.34",
               (const char *const[]){ "products=[knees]", NULL });
    struct transient_options o = transient_defaults(&s.scene);
    o.rtol = 1e-6;
    struct transient a = follow(&s, 1e-250, 1, &o),
                     b = follow(&s, 1e-40, 1, &o);
    assert_int_equal(a.sum.end, TRANSIENT_FADED);
    assert_int_equal(b.sum.end, TRANSIENT_FADED);
    CHECK(fabs(a.sum.slip.value - b.sum.slip.value) <=
              a.sum.slip.error + b.sum.slip.error,
          "%.17g +- %g, %.17g +- %g", a.sum.slip.value, a.sum.slip.error,
          b.sum.slip.value, b.sum.slip.error);
    double u[2][CURVE_DIM_MAX];
    curve_at(&a.curve, a.curve.count - 1, 1.0, u[0]);
    curve_at(&b.curve, b.curve.count - 1, 1.0, u[1]);
    CHECK(fabs(u[0][2] - u[1][2]) < 1e-6 * u[0][2], "%.17g, %.17g", u[0][2],
          u[1][2]);
    transient_free(&a);
    transient_free(&b);
    slope_free(&s);
}

static void a_block_that_runs_away_may_lose_psi_first(void **state)
{
    static const char *const law[] = { "ln_c_psi", "minus_log", "slip",
                                       "linear" };
    struct slope s;

    (void) state;
    make(&s, law, "0.3657");
    const struct transient_options o = transient_defaults(&s.scene);
    struct transient t = follow(&s, 1, 0.15, &o);
    assert_int_equal(t.sum.end, TRANSIENT_RUNAWAY);
    assert_string_equal(t.sum.time.reason, fate_runs_away);
    transient_free(&t);
    slope_free(&s);
}

/* Far below psi_ss next to no friction is left, of work nothing but what a
 * difference of numbers of order 1 rounds to: no step is asked for more of it.
 */
static void blocks_that_nothing_brakes_are_soon_followed_to_their_ends(
    void **state)
{
    static const struct {
        const char *law, *alpha;
        const char *const set[4];
        double v, psi;
        enum transient_end end;
    } of[] = {
        { "dieterich",
          "0.38",
          { "products=[knees]", "material.a=0.005", "material.b=0.045241" },
          1e-5,
          4.85e-6,
          TRANSIENT_RUNAWAY },
        { "ruina",
          "0.44551",
          { "products=[knees]", "material.a=0.0045114", "material.b=0.046481" },
          6.7e-4,
          -13.2,
          TRANSIENT_RUNAWAY },
        { "spinodal",
          "0.300363",
          { "products=[knees]", "material.a=0.007292", "material.b=0.074888" },
          0.0175,
          2.8e-6,
          TRANSIENT_ARREST },
    };

    (void) state;
    for (size_t i = 0; i < sizeof of / sizeof *of; i++) {
        struct slope s;
        slope_make(&s, of[i].law, NULL, of[i].alpha, of[i].set);
        const struct transient_options o = transient_defaults(&s.scene);
        struct transient t = follow(&s, of[i].v, of[i].psi, &o);
        CHECK(t.sum.end == (int) of[i].end && t.sum.steps < 5000,
              "%s: %s, %d steps", of[i].law, transient_end_names[t.sum.end],
              (int) t.sum.steps);
        transient_free(&t);
        slope_free(&s);
    }
}

/* psi, which its law's sinh holds to psi_ss, has any rate within a tolerance:
 * by 113 bits, and by push. */
static void a_rest_is_told_before_its_orbit_is_only_rounding(void **state)
{
    static const struct {
        double v, psi, time, slip;
    } of[] = { { 7896141.431990207, 0.2164086247222423, 3.601797462728606,
                 12020598.056240579 },
               { 0.0013812154239651261, 811009.5220468952,
                 5.922526598895392e-10, 4.247234424700657e-13 } };
    struct slope s;

    (void) state;
    slope_make(
        &s, "dieterich", "log", "0.257315",
        (const char *const[]){ "products=[knees]", "law.theta=ln(c + psi)",
                               "law.psi_ss=v^-q", "law.T=R/(1 + R*v)",
                               "law.K=sinh(d)", "material.q=1.17", NULL });
    const struct transient_options o = transient_defaults(&s.scene);
    for (size_t i = 0; i < sizeof of / sizeof *of; i++) {
        struct transient t = follow(&s, of[i].v, of[i].psi, &o);
        assert_int_equal(t.sum.end, TRANSIENT_REST);
        assert_true(fabs(t.sum.time.value - of[i].time) <= t.sum.time.error);
        assert_true(fabs(t.sum.slip.value - of[i].slip) <= t.sum.slip.error);
        assert_true(t.sum.time.error <= 1e-9 * of[i].time);
        assert_true(t.sum.slip.error <= 1e-9 * of[i].slip);
        transient_free(&t);
    }
    slope_free(&s);
}

/* It slides at v = 1e153, after a slip that no number holds. */
static void a_slip_beyond_all_numbers_is_told_at_once(void **state)
{
    struct slope s;

    (void) state;
    slope_make(&s, "ruina", NULL, "0.476737",
               (const char *const[]){ "products=[knees]", "material.a=0.035842",
                                      "material.b=0.035425", NULL });
    const struct transient_options o = transient_defaults(&s.scene);
    struct transient t = follow(&s, 8e5, 7.25, &o);
    assert_int_equal(t.sum.fate, FATE_SLIDING);
    assert_int_equal(t.sum.end, TRANSIENT_LOST);
    assert_string_equal(t.reason, "it slips further than any number holds");
    transient_free(&t);
    slope_free(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(starts_below_all_slow_curves_are_followed),
        cmocka_unit_test(starts_at_any_v_end_in_bounded_work),
        cmocka_unit_test(friction_that_is_nothing_costs_no_steps),
        cmocka_unit_test(
            a_block_that_rose_from_far_below_fades_where_others_do),
        cmocka_unit_test(a_block_that_runs_away_may_lose_psi_first),
        cmocka_unit_test(
            blocks_that_nothing_brakes_are_soon_followed_to_their_ends),
        cmocka_unit_test(a_rest_is_told_before_its_orbit_is_only_rounding),
        cmocka_unit_test(a_slip_beyond_all_numbers_is_told_at_once),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
