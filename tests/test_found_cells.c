/* States that random ones (test_random_cells.c) found, each of which had no
 * number, or a wrong one. */
#include "cells_of.h"

#include "fast_cells.h"
#include "study.h"

/* A slope: components of its law as of law.h, and its material. */
struct found {
    enum friction_form form;
    enum theta theta;
    enum psi_ss psi_ss;
    enum timescale timescale;
    double mu_star, a, b, c, R, L, V_star, alpha, rtol;
};

static void make(const struct found *f, struct slope *s)
{
    struct scene *scene = &s->scene;
    struct fault why;

    slope_scene(scene, "spinodal_gen", NULL, "0.34", steady_only);
    scene->law.form = f->form;
    scene->law.theta = f->theta;
    scene->law.psi_ss = f->psi_ss;
    scene->law.timescale = f->timescale;
    scene->material.mu_star = f->mu_star;
    scene->material.a = f->a;
    scene->material.b = f->b;
    scene->material.c = f->c;
    scene->material.R = f->R;
    scene->material.L = f->L;
    scene->material.V_star = f->V_star;
    scene->alpha = f->alpha;
    scene->tan_alpha = tanl((long double) f->alpha);
    const enum status status = study_run(&s->study, scene, NULL, &why);
    CHECK(status == STATUS_OK, "%s", why.text);
}

/* The state's cell, whose slip, time and mean friction are those of a tight
 * orbit, if it has any. */
static struct cell compare(const struct found *f, double x, double y)
{
    const struct vec2 z = { x, y };
    static struct slope s;
    struct fast_cells fast;
    struct fate_result r;
    struct cell c;

    make(f, &s);
    assert_int_equal(fast_cells_init(&fast, &s.study, NULL), 0);
    assert_int_equal(
        fast_cells_find(&fast, &z, 1, f->rtol, ALL, NULL, &c, NULL), 0);
    assert_int_equal(fate_find(&s.study, z, 1e-11, true, NULL, &r), 0);
    assert_int_equal(c.exit_reason, r.fate);
    const struct quantity *tight[] = { &r.slip, &r.time, &r.mu_mean };
    for (int k = 0; k < 3; k++) {
        const double v = value(&c, (enum cell_field) k);
        const double bar = error(&c, (enum cell_field) k);
        CHECK(isnan(v) == !quantity_exists(tight[k]), "%d: %g", k, v);
        CHECK(isnan(v) || fabs(v - tight[k]->value) <= bar + tight[k]->error,
              "%d: %.16g +- %g, not %.16g +- %g", k, v, bar, tight[k]->value,
              tight[k]->error);
    }
    fast_cells_free(&fast);
    slope_free(&s);
    return c;
}

static void a_leap_of_psi_leaves_time_its_digits(void **state)
{
    const struct found found[] = {
        { FRICTION_ASINH, THETA_LN_PSI, PSI_SS_INVERSE, TIMESCALE_SLIP, 0.369,
          0.0249537756, 0.0489, 0.0, 100.0, 1.58844299e-06, 1e-6, 0.560753929,
          1e-9 },
        { FRICTION_ASINH, THETA_LN_PSI, PSI_SS_INVERSE, TIMESCALE_SLIP, 0.369,
          0.0361264472, 0.0489, 0.0, 100.0, 3.70388891e-08, 1e-6, 0.44970205,
          1e-5 },
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
static const struct found beyond = { FRICTION_ASINH,
                                     THETA_PSI,
                                     PSI_SS_INVERSE,
                                     TIMESCALE_AGEING44,
                                     0.125222685,
                                     0.0329618374,
                                     0.0490999756,
                                     0.177913822,
                                     277860.445,
                                     3.97831434e-05,
                                     0.000974869886,
                                     0.59823129,
                                     1e-9 };

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

static void steep_curves_are_as_good_between_knots(void **state)
{
    const struct found found = { FRICTION_ASINH,
                                 THETA_LN_C_1PR_PSI,
                                 PSI_SS_SPINODAL_UNIT,
                                 TIMESCALE_SPINODAL,
                                 0.369,
                                 0.0251565578,
                                 0.0489,
                                 0.000129695329,
                                 625.609377,
                                 2.24450958e-08,
                                 1e-6,
                                 0.231577357,
                                 1e-9 };

    (void) state;
    compare(&found, 13.506162953085532, -12.057390670952433);
}

static void landings_wait_until_a_sinh_is_as_good_as_linear(void **state)
{
    const struct found found = {
        FRICTION_LOG, THETA_LN_C_1PR_PSI, PSI_SS_INVERSE, TIMESCALE_SLIP,
        0.879741752,  0.114762378,        0.0317581503,   1.24052702e-06,
        14.0922193,   1.30771606e-06,     0.000134292235, 0.141912835,
        1e-6
    };

    (void) state;
    compare(&found, -7.2414024586896204, 10.860000929958943);
    compare(&found, -7.8388120328687823, 10.870927683319076);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_leap_of_psi_leaves_time_its_digits),
        cmocka_unit_test(
            a_block_at_rest_beyond_all_psi_slips_less_than_its_bar),
        cmocka_unit_test(the_mean_friction_holds_the_work_after_the_orbits_end),
        cmocka_unit_test(steep_curves_are_as_good_between_knots),
        cmocka_unit_test(landings_wait_until_a_sinh_is_as_good_as_linear),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
