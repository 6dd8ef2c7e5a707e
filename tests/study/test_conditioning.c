/* What rounding the inputs costs: against sensitivities, tables and closed
 * forms. */
#include "conditioning.h"

#include <math.h>

#include "check.h"
#include "reference_rows.h"
#include "starved_study.h"
#include "study.h"

/* A study of one slope with sensitivities; the scene must not move. */
static void study_of(struct study *s, struct scene *scene,
                     const struct law *law, const struct material *m,
                     double alpha)
{
    struct fault why;

    *scene = (struct scene){
        .law = *law,
        .material = *m,
        .alpha = alpha,
        .tan_alpha = tanl((long double) alpha),
        .window = { { 1e-6, 1e6 }, { 1e-3, 1e2 }, AXES_LOG },
        .products = 1u << PRODUCT_KNEES | 1u << PRODUCT_SENSITIVITIES,
        .rtol = 1e-12,
    };
    const enum status status = study_run(s, scene, NULL, &why);
    CHECK(status == STATUS_OK, "%s, alpha = %g: %.300s", law->preset, alpha,
          why.text);
}

static double value_of(const struct scene *c, enum parameter which)
{
    switch (which) {
        case PARAMETER_ALPHA:
            return c->alpha;
        case PARAMETER_A:
            return c->material.a;
        case PARAMETER_B:
            return c->material.b;
        case PARAMETER_MU_STAR:
            return c->material.mu_star;
        case PARAMETER_C:
            return c->material.c;
        case PARAMETER_R:
            return c->material.R;
        default:
            return material_eps2(&c->material);
    }
}

/* sum |S_p p|, eps2 made of V_star^2, L and g. */
static double amplification(const struct scene *c,
                            const struct sensitivity_numbers *d)
{
    double sum = 0.0;

    for (int k = 0; k < PARAMETERS; k++)
        if (quantity_exists(&d->by[k]))
            sum += fabs(d->by[k].value * value_of(c, (enum parameter) k)) *
                   (k == PARAMETER_EPS2 ? 4.0 : 1.0);
    return sum;
}

static void check_conditioning(const struct csv *c, const struct quantity *q,
                               double sum, double digits, size_t *compared)
{
    if (!quantity_exists(q) || isnan(digits))
        return;
    CHECK(fabs(q->conditioning / (0x1p-53 * sum) - 1) < 0.02,
          "row %zu: conditioning %g, sensitivities say %g", c->row,
          q->conditioning, 0x1p-53 * sum);
    /* the column holds alpha's share, to two decimals, nothing below 1 */
    const double lost = log10(q->conditioning / 0x1p-53);
    CHECK(lost > digits - 0.02 && lost < digits + 2.5,
          "row %zu: %.2f digits, the table says %.2f", c->row, lost, digits);
    ++*compared;
}

static size_t check_digits(const char *name)
{
    struct csv c;
    size_t compared = 0;

    csv_open(&c, name);
    while (csv_next(&c)) {
        const struct law law = row_law(&c);
        const struct material m = row_material(&c);
        struct scene scene;
        struct study s;
        if (c.row % 3 != 0)
            continue;
        study_of(&s, &scene, &law, &m, csv_number(&c, "alpha", 0));
        check_conditioning(&c, &s.slider.critical.v_plus,
                           amplification(&scene, &s.sensitivities.v_plus),
                           csv_number(&c, "digits_lost_alpha_vplus", NAN),
                           &compared);
        check_conditioning(&c, &s.slider.critical.v_minus,
                           amplification(&scene, &s.sensitivities.v_minus),
                           csv_number(&c, "digits_lost_alpha_lower", NAN),
                           &compared);
        study_free(&s);
    }
    return compared;
}

static void conditioning_is_the_digits_lost(void **state)
{
    (void) state;
    const size_t compared =
        check_digits("manifold.csv") + check_digits("extreme.csv");
    CHECK(compared > 60, "only %zu", compared);
}

/* (29) in the log form: ln v_sp = (mu_star - tan(alpha))/(b - a). */
static void every_number_has_its_conditioning(void **state)
{
    struct law law = *law_preset_find("dieterich_gen");
    const struct material m = material_bristol_board();
    const double t = tan(0.34), d = m.b - m.a, x = (m.mu_star - t) / d;
    struct scene scene;
    struct study s;

    (void) state;
    law.form = FRICTION_LOG;
    study_of(&s, &scene, &law, &m, 0.34);
    const double by_alpha = 0.34 * (1 + t * t) / d, by_mu = m.mu_star / d;
    const double by_ab = fabs(x) * (m.a + m.b) / d;
    const double want = 0x1p-53 * (by_alpha + by_mu + by_ab);
    CHECK(fabs(s.saddle_numbers.v.conditioning / want - 1) < 1e-3, "%g, not %g",
          s.saddle_numbers.v.conditioning, want);
    CHECK(s.slider.steady[0].v.conditioning == s.saddle_numbers.v.conditioning,
          "%g", s.slider.steady[0].v.conditioning);
    const struct quantity *q[] = {
        &s.slider.critical.x_excess,        &s.slider.critical.x_deficit,
        &s.slider.critical.mu_s_num,        &s.slider.critical.mu_s_mean,
        &s.slider.critical.fracture_energy, &s.slider.critical.knee_upper.v,
        &s.slider.critical.knee_lower.psi,  &s.slider.critical.knees_upper[0].v,
        &s.saddle_numbers.lambda_plus,
    };
    for (size_t i = 0; i < sizeof q / sizeof *q; i++)
        CHECK(q[i]->conditioning > 1e-17 && q[i]->conditioning < 1e-12,
              "number %zu: %g", i, q[i]->conditioning);
    study_free(&s);
}

static void a_slope_given_by_its_tangent_has_that_rounded(void **state)
{
    struct law law = *law_preset_find("dieterich_gen");
    const struct material m = material_bristol_board();
    const double t = 0.36, d = m.b - m.a, x = (m.mu_star - t) / d;
    struct scene scene;
    struct study s;
    struct fault why;

    (void) state;
    law.form = FRICTION_LOG;
    study_of(&s, &scene, &law, &m, atan(t));
    study_free(&s);
    scene.tan_alpha = (long double) t;
    assert_int_equal(study_run(&s, &scene, NULL, &why), STATUS_OK);
    const double want = 0x1p-53 * (t + m.mu_star + fabs(x) * (m.a + m.b)) / d;
    const double got = s.saddle_numbers.v.conditioning;
    study_free(&s);
    CHECK(fabs(got / want - 1) < 1e-3, "%g, not %g", got, want);
}

static void a_wrong_sensitivity_gets_a_bar_that_shows_it(void **state)
{
    const struct law *law = law_preset_find("spinodal_gen");
    const struct material m = material_bristol_board();
    struct scene scene;
    struct study s;
    size_t evaluations = 0;

    (void) state;
    study_of(&s, &scene, law, &m, 0.34);
    struct sensitivities wrong = s.sensitivities;
    const struct sensitivities right = wrong;
    wrong.v_plus.by[PARAMETER_ALPHA].value *= 1.1;
    wrong.v_plus.by[PARAMETER_EPS2].value *= -1.0;
    wrong.v_minus.by[PARAMETER_B].value = 0.0;
    assert_int_equal(conditioning_find(&s, NULL, &wrong, &evaluations),
                     STATUS_OK);
    for (int k = 0; k < 2 * PARAMETERS; k++) {
        const struct quantity *w =
            k % 2 ? &wrong.v_minus.by[k / 2] : &wrong.v_plus.by[k / 2];
        const struct quantity *r =
            k % 2 ? &right.v_minus.by[k / 2] : &right.v_plus.by[k / 2];
        const double off = fabs(w->value - r->value);
        CHECK(w->error >= 0.999 * off, "p = %d: off by %g, bar %g", k / 2, off,
              w->error);
        CHECK(off > 0 || w->error == r->error, "p = %d: bar %g, was %g", k / 2,
              w->error, r->error);
    }
    study_free(&s);
}

/* Failing every one of some hundred, all alike after the first, takes long. */
static void allocations_may_fail(void **state)
{
    const struct law *law = law_preset_find("spinodal_gen");
    const struct material m = material_bristol_board();
    struct scene scene;
    struct study s;

    (void) state;
    study_of(&s, &scene, law, &m, 0.34);
    study_free(&s);
    starve_study(&scene, 50);
}

static int stop(void *ctx, const char *stage, uint64_t done, uint64_t total)
{
    int *told = ctx;

    (void) total;
    *told += strcmp(stage, "sensitivities") == 0 && done > 2;
    return *told > 0;
}

static void a_monitor_stops_it(void **state)
{
    const struct law *law = law_preset_find("spinodal_gen");
    const struct material m = material_bristol_board();
    struct scene scene;
    struct study s;
    struct fault why;
    int told = 0;
    const struct monitor monitor = { stop, &told };

    (void) state;
    study_of(&s, &scene, law, &m, 0.34);
    study_free(&s);
    assert_int_equal(study_run(&s, &scene, &monitor, &why), STATUS_STOPPED);
    assert_int_equal(told, 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(conditioning_is_the_digits_lost),
        cmocka_unit_test(every_number_has_its_conditioning),
        cmocka_unit_test(a_slope_given_by_its_tangent_has_that_rounded),
        cmocka_unit_test(a_wrong_sensitivity_gets_a_bar_that_shows_it),
        cmocka_unit_test(allocations_may_fail),
        cmocka_unit_test(a_monitor_stops_it),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
