/* States that random ones (test_random_cells.c) found, each of which had no
 * number, or a wrong one. */
#include "cells_of.h"

#include "fast_cells.h"
#include "found.h"
#include "peak.h"
#include "quad_orbit.h"
#include "study.h"

static void run(struct slope *s)
{
    struct fault why;
    const enum status status = study_run(&s->study, &s->scene, NULL, &why);

    CHECK(status == STATUS_OK, "%s", why.text);
}

static void make(const struct found *f, struct slope *s)
{
    found_scene(f, steady_only, &s->scene);
    run(s);
}

/* At a slope with more digits than a double has. */
static void make_at(const struct found *f, long double tan_alpha,
                    struct slope *s)
{
    found_scene(f, steady_only, &s->scene);
    s->scene.tan_alpha = tan_alpha;
    s->scene.alpha = (double) atanl(tan_alpha);
    run(s);
}

/* The values of an orbit, and its errors, in the order of enum cell_field. */
static void follow(const struct study *s, struct vec2 z, double rtol,
                   enum fate *fate, double of[], double left[])
{
    struct fate_result r;
    struct peaks p;

    assert_int_equal(fate_find(&s->slider, z, rtol, true, NULL, &r), 0);
    assert_int_equal(peaks_find(&s->slider, z, rtol, r.steps, &p), 0);
    const struct quantity *q[] = { &r.slip, &r.time, &r.mu_mean };
    for (int k = 0; k < 3; k++) {
        of[k] = quantity_exists(q[k]) ? q[k]->value : (double) NAN;
        left[k] = q[k]->error;
    }
    of[CELL_V_PEAK] = exp(p.x);
    of[CELL_MU_PEAK] = r.fate == FATE_REST_FINITE ? (double) NAN : p.mu;
    left[CELL_V_PEAK] = left[CELL_MU_PEAK] = 0.0;
    *fate = r.fate;
}

/* Those of a tight one; its own errors show as what a finer one changes. */
static enum fate follow_twice(const struct study *s, struct vec2 z,
                              double tight[], double left[])
{
    double coarse[CELL_FIELDS];
    enum fate fate, before;

    follow(s, z, 1e-11, &before, coarse, left);
    follow(s, z, 1e-13, &fate, tight, left);
    assert_int_equal(fate, before);
    for (int k = 0; k < CELL_FIELDS; k++)
        left[k] += fabs(tight[k] - coarse[k]);
    return fate;
}

/* The state's cell, each number of which is that of a tight orbit, if it has
 * any. */
static struct cell compare(const struct found *f, double x, double y)
{
    const struct vec2 z = { x, y };
    double tight[CELL_FIELDS], left[CELL_FIELDS];
    static struct slope s;
    struct fast_cells fast;
    struct cell c;

    make(f, &s);
    assert_int_equal(fast_cells_init(&fast, &s.study.slider, NULL), 0);
    assert_int_equal(
        fast_cells_find(&fast, &z, 1, f->rtol, ALL, NULL, &c, NULL), 0);
    assert_int_equal(c.exit_reason, follow_twice(&s.study, z, tight, left));
    for (int k = 0; k < CELL_FIELDS; k++) {
        const double v = value(&c, (enum cell_field) k);
        const double bar = error(&c, (enum cell_field) k);
        CHECK(isnan(v) == isnan(tight[k]), "%d: %g", k, v);
        CHECK(isnan(v) || fabs(v - tight[k]) <= bar + left[k],
              "%d: %.16g +- %g, not %.16g +- %g", k, v, bar, tight[k], left[k]);
    }
    fast_cells_free(&fast);
    slope_free(&s);
    return c;
}

static void a_leap_of_psi_leaves_time_its_digits(void **state)
{
    const struct found found[] = {
        { FRICTION_ASINH, THETA_LN_PSI, PSI_SS_INVERSE, TIMESCALE_SLIP,
          KINETICS_SINH, 0.369, 0.0249537756, 0.0489, 0.0, 100.0,
          1.58844299e-06, 1e-6, 0.560753929, 1e-9 },
        { FRICTION_ASINH, THETA_LN_PSI, PSI_SS_INVERSE, TIMESCALE_SLIP,
          KINETICS_SINH, 0.369, 0.0361264472, 0.0489, 0.0, 100.0,
          3.70388891e-08, 1e-6, 0.44970205, 1e-5 },
    };
    const struct cell c[] = {
        compare(&found[0], -16.481069712130409, 10.213254749340509),
        compare(&found[1], -14.291430703470866, 9.3906127699808657),
    };

    (void) state;
    for (int i = 0; i < 2; i++) {
        assert_int_equal(c[i].exit_reason, FATE_REST_FINITE);
        CHECK(c[i].slip_error <= 1e-5 * c[i].slip, "%g +- %g", c[i].slip,
              c[i].slip_error);
    }
}

/* What psi may be ends at 687, where friction still grows. */
static const struct found beyond = {
    FRICTION_ASINH, THETA_PSI,   PSI_SS_INVERSE, TIMESCALE_AGEING44,
    KINETICS_SINH,  0.125222685, 0.0329618374,   0.0490999756,
    0.177913822,    277860.445,  3.97831434e-05, 0.000974869886,
    0.59823129,     1e-9
};

static void a_block_at_rest_beyond_all_psi_slips_less_than_its_bar(void **state)
{
    const struct cell c =
        compare(&beyond, -11.535466503486223, 14.702972833062338);

    (void) state;
    assert_int_equal(c.exit_reason, FATE_REST_FINITE);
    CHECK(c.slip > 0.0 && c.slip_error >= c.slip && c.slip_error < 1.1 * c.slip,
          "%g +- %g", c.slip, c.slip_error);
    CHECK(c.time > 0.0 && c.time_error >= c.time, "%g +- %g", c.time,
          c.time_error);
    assert_true(isnan(c.mu_mean));
}

/* (27) */
static void the_mean_friction_holds_the_work_after_the_orbits_end(void **state)
{
    const double x = -2.4712194582380711;
    const struct cell c = compare(&beyond, x, 15.566612061694961);
    const double V = beyond.V_star, eps2 = V * V / (9.81 * beyond.L);
    const double start = 0.5 * eps2 * exp(2.0 * x) / cos(beyond.alpha);
    const double mean = tan(beyond.alpha) + start / c.slip;

    (void) state;
    is_near(&c, CELL_MU_MEAN, mean);
}

/* An orbit that is off along itself by dt is off by v dt in slip. */
static void time_is_known_no_better_than_the_slip_of_that_time(void **state)
{
    static struct slope s;
    struct fast_cells fast;
    struct slow_point p;

    (void) state;
    make(&beyond, &s);
    assert_int_equal(fast_cells_init(&fast, &s.study.slider, NULL), 0);
    assert_true(slow_curve_at(&fast.curve, -13.0525, &p));
    const double v = s.study.slider.block.at.v0 * exp(p.x_peak);
    CHECK(p.time_error * v > 0.5 * p.slip_error, "%g at %g, but %g",
          p.time_error, v, p.slip_error);
    fast_cells_free(&fast);
    slope_free(&s);
}

static void steep_curves_are_as_good_between_knots(void **state)
{
    const struct found found = { FRICTION_ASINH,       THETA_LN_C_1PR_PSI,
                                 PSI_SS_SPINODAL_UNIT, TIMESCALE_SPINODAL,
                                 KINETICS_SINH,        0.369,
                                 0.0251565578,         0.0489,
                                 0.000129695329,       625.609377,
                                 2.24450958e-08,       1e-6,
                                 0.231577357,          1e-9 };

    (void) state;
    compare(&found, 13.506162953085532, -12.057390670952433);
}

static void landings_wait_until_a_sinh_is_as_good_as_linear(void **state)
{
    const struct found found = { FRICTION_LOG,   THETA_LN_C_1PR_PSI,
                                 PSI_SS_INVERSE, TIMESCALE_SLIP,
                                 KINETICS_SINH,  0.879741752,
                                 0.114762378,    0.0317581503,
                                 1.24052702e-06, 14.0922193,
                                 1.30771606e-06, 0.000134292235,
                                 0.141912835,    1e-6 };

    (void) state;
    compare(&found, -7.2414024586896204, 10.860000929958943);
    compare(&found, -7.8388120328687823, 10.870927683319076);
}

static void psi_may_wait_for_the_curve_to_come(void **state)
{
    const struct found rests = {
        FRICTION_LOG,   THETA_LN_PSI, PSI_SS_INVERSE, TIMESCALE_SLIP,
        KINETICS_SINH,  0.369,        0.0219892452,   0.0489,
        0.000401063109, 188.484027,   5.38630293e-08, 1e-06,
        0.517854746,    1e-6
    };
    const struct found creeps = {
        FRICTION_LOG,   THETA_LN_PSI, PSI_SS_SPINODAL, TIMESCALE_SPINODAL,
        KINETICS_SINH,  0.651857423,  0.0796835865,    0.0609004775,
        6.93172139e-05, 8878740.35,   5.95548022e-07,  2.86871348e-08,
        0.419517923,    1e-6
    };

    (void) state;
    compare(&rests, -12.213526553059813, 12.238784631675209);
    compare(&creeps, -9.7933812135182183, 11.204608995365687);
}

static void what_an_orbit_closes_in_on_is_ahead_or_behind(void **state)
{
    const struct found found[] = {
        { FRICTION_LOG, THETA_LN_C_PSI, PSI_SS_SPINODAL, TIMESCALE_SPINODAL,
          KINETICS_SINH, 0.369, 0.0241448779, 0.0489, 0.000100381771,
          472.487866, 5.30286768e-07, 1e-06, 0.248212835, 1e-4 },
        { FRICTION_LOG, THETA_LN_C_PSI, PSI_SS_SPINODAL, TIMESCALE_SPINODAL,
          KINETICS_SINH, 0.369, 0.0308987929, 0.0489, 0.00201907438, 217.547623,
          2.43544731e-06, 1e-06, 0.282381764, 1e-7 },
    };

    (void) state;
    compare(&found[0], -2.8902225912148216, -3.332260471116796);
    compare(&found[1], -3.2626857573984793, -8.5427197634994574);
}

static void a_peak_on_a_loose_step_has_a_bar_of_its_own(void **state)
{
    const struct found found = { FRICTION_LOG,    THETA_LN_C_PSI,
                                 PSI_SS_SPINODAL, TIMESCALE_SPINODAL,
                                 KINETICS_LINEAR, 0.369,
                                 0.0212515757,    0.0489,
                                 0.003987698,     10.3287651,
                                 1.40647463e-05,  1e-06,
                                 0.354135655,     1e-7 };

    (void) state;
    compare(&found, -3.2523156465918306, 0.78056024432239168);
}

static void a_peak_is_found_between_samples_of_an_orbit_not_run_again(
    void **state)
{
    const struct found found = { FRICTION_LOG,    THETA_LN_C_PSI,
                                 PSI_SS_SPINODAL, TIMESCALE_SPINODAL,
                                 KINETICS_SINH,   0.262152843,
                                 0.00206396759,   0.00776047298,
                                 0.0394271523,    77391394.7,
                                 0.000727729876,  1.53459861e-08,
                                 0.290773017,     1e-9 };
    const struct vec2 z = { -8.4451890677903485, 3.5250066084953966 };
    const double rtol[] = { 1e-9, 1e-10, 5e-11, 1e-11 };
    static struct slope s;
    struct fate_result r;
    struct peaks p[4];

    (void) state;
    make(&found, &s);
    for (int i = 0; i < 4; i++) {
        assert_int_equal(
            fate_find(&s.study.slider, z, rtol[i], false, NULL, &r), 0);
        assert_int_equal(
            peaks_find(&s.study.slider, z, rtol[i], r.steps, &p[i]), 0);
        CHECK(fabs(p[i].mu - p[0].mu) < 1e-12, "%.16g, not %.16g at %g",
              p[i].mu, p[0].mu, rtol[i]);
    }
    slope_free(&s);
}

/* Where rates are 1e24 apart the curve's orbit is rounding, in steps of any
 * length: a curvature by a short one is no use on a long one beside it. */
static void rounding_along_the_curve_is_no_peak_of_friction(void **state)
{
    const struct found found = { FRICTION_ASINH,  THETA_LN_C_PSI,
                                 PSI_SS_INVERSE,  TIMESCALE_SPINODAL,
                                 KINETICS_LINEAR, 0.655983727,
                                 0.00793591462,   0.0372405348,
                                 4.69875173e-05,  0.350122547,
                                 0.00064741692,   0.00013358246,
                                 0.486698342,     1e-6 };

    (void) state;
    compare(&found, 2.0260646961923072, -6.6063353509104505);
}

static void v_may_settle_while_psi_still_leaps(void **state)
{
    static const struct found turns = {
        FRICTION_ASINH,         THETA_LN_C_1PR_PSI,
        PSI_SS_SPINODAL,        TIMESCALE_SLIP,
        KINETICS_SINH,          0.39343915979375177,
        0.21239659901634647,    0.23054647456497085,
        0.28529951669061571,    36062326.31883496,
        0.00038857111452964916, 2.7804906347175084e-08,
        1.3488332159631249,     1e-9
    };

    (void) state;
    compare(&turns, -3.5485524304815055, 0.19157890932054);
}

/* Of slopes, as long doubles: a node is known to its rounding, which may be as
 * small as it likes at one of them. */
static void the_face_of_a_box_is_as_wrong_as_its_node(void **state)
{
    static const struct found node = { FRICTION_LOG,
                                       THETA_LN_C_PSI,
                                       PSI_SS_SPINODAL,
                                       TIMESCALE_SPINODAL,
                                       KINETICS_SINH,
                                       0.369,
                                       0.030699321576861248,
                                       0.0489,
                                       0.00028490258829448519,
                                       173.0357353051192,
                                       1.9065023601466705e-07,
                                       1e-6,
                                       0.0,
                                       1e-8 };
    const struct vec2 z = { 3.2342926851231866, 0.76126088109832457 };
    static struct quad_slope q;
    static struct slope s;
    double bar = 0.0, off = 0.0;
    struct fast_cells fast;
    struct quad_orbit t;
    struct cell c;

    (void) state;
    for (int i = 0; i < 6; i++) {
        make_at(&node, 0.426405707621409282133L + 1e-5L * i, &s);
        quad_slope_init(&q, &s.study);
        assert_int_equal(fast_cells_init(&fast, &s.study.slider, NULL), 0);
        assert_int_equal(
            fast_cells_find(&fast, &z, 1, 1e-8, ALL, NULL, &c, NULL), 0);
        quad_orbit_find(&q, (quad) z.x, (quad) z.y, 1e-8, &t);
        const double e = fabs((double) ((quad) c.slip - t.value[CELL_SLIP]));
        CHECK(e <= c.slip_error, "%g is off %g", c.slip_error, e);
        bar = fmax(bar, c.slip_error);
        off = fmax(off, e);
        fast_cells_free(&fast);
        slope_free(&s);
    }
    CHECK(bar < 100.0 * off, "%g for %g", bar, off);
}

/* In 113 bits, whose friction is the slope's there, at this one to all digits.
 */
static void v_may_rise_where_its_rest_is_known(void **state)
{
    static const struct found below = { FRICTION_ASINH,
                                        THETA_LN_PSI,
                                        PSI_SS_INVERSE,
                                        TIMESCALE_SLIP,
                                        KINETICS_LINEAR,
                                        0.369,
                                        0.023136378877920673,
                                        0.0489,
                                        0.0040038059188324815,
                                        295.54509595478493,
                                        1.2125443594073605e-05,
                                        1e-6,
                                        0.0,
                                        1e-10 };
    const struct vec2 z = { -14.580516889147628, 11.909791629865099 };
    static struct slope s;
    struct cell c;

    (void) state;
    make_at(&below, 0.629509396859851262282L, &s);
    find(&s, &z, 1, 1e-10, ALL, &c);
    is_near(&c, CELL_V_PEAK, 9.0777968561207354e-07);
    is_near(&c, CELL_MU_PEAK, 0.6295093968598513);
    slope_free(&s);
}

/* In 113 bits: it lands 4e-7 beside the curve, between knots 0.1 apart. */
static void a_rest_is_where_it_is_between_knots(void **state)
{
    static const struct found rest = { FRICTION_LOG,
                                       THETA_LN_C_PSI,
                                       PSI_SS_INVERSE,
                                       TIMESCALE_AGEING44,
                                       KINETICS_SINH,
                                       0.49085619719582962,
                                       0.002879235758113967,
                                       0.0092391829957984527,
                                       0.016085475777589106,
                                       44462158.596703082,
                                       2.3264835373174646e-07,
                                       1.2277689107956845e-08,
                                       0.0,
                                       1e-9 };
    const struct vec2 z = { -4.1743157775067168, 2.5245494576454632 };
    static struct slope s;
    struct fast_cells fast;
    struct cell c;

    (void) state;
    make_at(&rest, 0.473518223520759871974L, &s);
    assert_int_equal(fast_cells_init(&fast, &s.study.slider, NULL), 0);
    assert_int_equal(fast_cells_find(&fast, &z, 1, 1e-9,
                                     1u << CELL_SLIP | 1u << CELL_TIME, NULL,
                                     &c, NULL),
                     0);
    is_near(&c, CELL_SLIP, 2.2533773790394205e-13);
    CHECK(c.slip_error < 1e-9 * c.slip, "%g", c.slip_error);
    fast_cells_free(&fast);
    slope_free(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_leap_of_psi_leaves_time_its_digits),
        cmocka_unit_test(
            a_block_at_rest_beyond_all_psi_slips_less_than_its_bar),
        cmocka_unit_test(the_mean_friction_holds_the_work_after_the_orbits_end),
        cmocka_unit_test(time_is_known_no_better_than_the_slip_of_that_time),
        cmocka_unit_test(steep_curves_are_as_good_between_knots),
        cmocka_unit_test(landings_wait_until_a_sinh_is_as_good_as_linear),
        cmocka_unit_test(psi_may_wait_for_the_curve_to_come),
        cmocka_unit_test(v_may_settle_while_psi_still_leaps),
        cmocka_unit_test(a_rest_is_where_it_is_between_knots),
        cmocka_unit_test(the_face_of_a_box_is_as_wrong_as_its_node),
        cmocka_unit_test(v_may_rise_where_its_rest_is_known),
        cmocka_unit_test(what_an_orbit_closes_in_on_is_ahead_or_behind),
        cmocka_unit_test(a_peak_on_a_loose_step_has_a_bar_of_its_own),
        cmocka_unit_test(
            a_peak_is_found_between_samples_of_an_orbit_not_run_again),
        cmocka_unit_test(rounding_along_the_curve_is_no_peak_of_friction),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
