/* What the scatter of inputs makes of numbers: against exact sensitivities,
 * closed forms and studies in which an input is moved. */
#include "scatter.h"

#include <math.h>
#include <stdio.h>

#include "check.h"
#include "own_folder.h"
#include "scene_units.h"
#include "starved_study.h"
#include "study.h"

/* The scene of these lines, and its study; neither may move. */
static void study_of(struct study *s, struct scene *scene, const char *text)
{
    const char *path = own_path("s.yaml");
    struct fault why = { "" };
    FILE *out = fopen(path, "w");

    assert_non_null(out);
    assert_true(fputs(text, out) >= 0);
    assert_int_equal(fclose(out), 0);
    CHECK(scene_read(scene, path, NULL, 0, &why) == STATUS_OK, "%.400s",
          why.text);
    CHECK(study_run(s, scene, NULL, &why) == STATUS_OK, "%.400s", why.text);
}

static void done(struct study *s, struct scene *scene)
{
    study_free(s);
    scene_free(scene);
}

#define PRODUCTS "products: [equilibria, folds, knees, sensitivities]\n"

static void its_square_is_the_sum_of_squares_of_sensitivities(void **state)
{
    static const char *const law[] = { "spinodal_gen", "dieterich_gen",
                                       "perrin" };
    char text[400];

    (void) state;
    for (size_t i = 0; i < sizeof law / sizeof *law; i++) {
        struct scene scene;
        struct study s;
        snprintf(text, sizeof text,
                 "law: {preset: %s}\n" PRODUCTS
                 "slope: {alpha: 0.34 +- 0.002}\n"
                 "material: {a: 0.0349 +- 0.0005, b: 0.0489 +- 0.0003, "
                 "L: 0.9e-6 +- 1e-7, V_star: 1e-6 +- 2e-8}\n",
                 law[i]);
        study_of(&s, &scene, text);
        const struct quantity *by = s.sensitivities.v_plus.by;
        const double eps2 = by[PARAMETER_EPS2].value *
                            material_eps2(&scene.material); /* V^2/(g L) */
        const double part[] = { by[PARAMETER_ALPHA].value * 0.002,
                                by[PARAMETER_A].value * 0.0005,
                                by[PARAMETER_B].value * 0.0003,
                                eps2 * 0.1 / 0.9, eps2 * 2 * 0.02 };
        double sum = 0.0;
        for (size_t k = 0; k < sizeof part / sizeof *part; k++)
            sum += part[k] * part[k];
        const double got = s.slider.critical.ln_v_plus.spread;
        CHECK(fabs(got / sqrt(sum) - 1) < 1e-3, "%s: %g, not %g", law[i], got,
              sqrt(sum));
        CHECK(fabs(s.slider.critical.v_plus.spread /
                       (got * s.slider.critical.v_plus.value) -
                   1) < 1e-3,
              "%s", law[i]);
        done(&s, &scene);
    }
}

/* ln v_sp = (mu_star - tan(alpha))/(b - a) in the log form. */
static void an_input_that_is_zero_scatters(void **state)
{
    struct scene scene;
    struct study s;

    (void) state;
    study_of(&s, &scene,
             "law: {preset: dieterich_gen, friction: log}\n" PRODUCTS
             "slope: {tan_alpha: 0.01}\n"
             "material: {mu_star: 0 +- 0.001}\n");
    const double v = s.saddle_numbers.v.value;
    const double want = v * 0.001 / 0.014, got = s.saddle_numbers.v.spread;
    done(&s, &scene);
    CHECK(fabs(got / want - 1) < 1e-3, "%g, not %g", got, want);
}

/* Of the slip rate and of phi in SI units, when V_star is set to `V_star`. */
static void in_si(const char *V_star, struct quantity *v, struct quantity *phi)
{
    struct scene scene;
    struct study s;
    char text[200];

    snprintf(text, sizeof text,
             "law: {preset: dieterich_gen}\n" PRODUCTS
             "slope: {alpha: 0.34}\nmaterial: {V_star: %s}\n",
             V_star);
    study_of(&s, &scene, text);
    struct unit_system units = scene_units(&scene);
    units.si = true;
    *v = unit_quantity(&units, unit_find("V_star"), s.slider.critical.v_plus);
    *phi = unit_quantity(&units, unit_find("psi"), s.saddle_numbers.psi);
    done(&s, &scene);
}

static void units_that_scatter_are_in_what_is_told_in_them(void **state)
{
    struct quantity v, phi, up[2], down[2];

    (void) state;
    in_si("1e-6 +- 3e-8", &v, &phi);
    in_si("1.0001e-6", &up[0], &up[1]);
    in_si("0.9999e-6", &down[0], &down[1]);
    const double by_v = (up[0].value - down[0].value) / 2e-10 * 3e-8;
    const double by_phi = (up[1].value - down[1].value) / 2e-10 * 3e-8;
    CHECK(fabs(v.spread / fabs(by_v) - 1) < 1e-3, "v %g, not %g", v.spread,
          by_v);
    CHECK(fabs(phi.spread / fabs(by_phi) - 1) < 1e-3, "phi %g, not %g",
          phi.spread, by_phi);
    CHECK(isnan(up[0].spread), "%g: nobody asked", up[0].spread);
}

static void numbers_that_are_there_have_one_and_the_others_none(void **state)
{
    struct scene scene;
    struct study s;

    (void) state;
    study_of(&s, &scene,
             "law: {preset: spinodal_gen}\n" PRODUCTS
             "slope: {alpha: 0.34}\nmaterial: {a: 0.0349 +- 0.0005}\n");
    const struct critical_numbers *c = &s.slider.critical;
    CHECK(c->x_excess.spread > 0.0 && c->x_deficit.spread > 0.0 &&
              c->knees_upper[0].psi.spread > 0.0 &&
              s.slider.steady[0].lambda_plus.spread > 0.0 &&
              s.folds.c_cusp.spread > 0.0,
          "%g", c->x_excess.spread);
    CHECK(!quantity_exists(&c->psi_at_v0) && isnan(c->psi_at_v0.spread), "%g",
          c->psi_at_v0.spread);
    done(&s, &scene);
}

static void allocations_may_fail(void **state)
{
    struct scene scene;
    struct study s;

    (void) state;
    study_of(&s, &scene,
             "law: {preset: dieterich_gen}\nproducts: [knees]\n"
             "slope: {alpha: 0.34}\nmaterial: {a: 0.0349 +- 0.0005}\n");
    study_free(&s);
    starve_study(&scene, 50);
    scene_free(&scene);
}

#define TEST(test)                                                             \
    cmocka_unit_test_setup_teardown(test, own_folder_make, own_folder_remove)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(its_square_is_the_sum_of_squares_of_sensitivities),
        TEST(an_input_that_is_zero_scatters),
        TEST(units_that_scatter_are_in_what_is_told_in_them),
        TEST(numbers_that_are_there_have_one_and_the_others_none),
        TEST(allocations_may_fail),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
