/* Fates, slips, times and fields of presets as formulas are those of presets by
 * name. */
#include <math.h>

#include "law_scenes.h"
#include "push.h"
#include "study.h"

static void same(const struct quantity *found, const struct quantity *exact,
                 const char *what, const char *law)
{
    CHECK(quantity_exists(found) == quantity_exists(exact), "%s: %s %s", law,
          what, found->reason ? found->reason : "is there");
    if (quantity_exists(found))
        CHECK(fabs(found->value - exact->value) <= found->error + exact->error,
              "%s: %s %.17g +- %g, not %.17g +- %g", law, what, found->value,
              found->error, exact->value, exact->error);
}

static void compare(const struct push_answer *f, const struct push_answer *e,
                    const char *law)
{
    CHECK(f->fate == e->fate, "%s: %s, not %s", law, fate_names[f->fate],
          fate_names[e->fate]);
    same(&f->slip, &e->slip, "slip", law);
    same(&f->time, &e->time, "time", law);
    same(&f->mu_mean, &e->mu_mean, "mu_mean", law);
    same(&f->v_kick, &e->v_kick, "v_kick", law);
    same(&f->psi_kick, &e->psi_kick, "psi_kick", law);
}

static struct law some_law(int i)
{
    struct law law = *law_preset_at((size_t) i % 8);

    law.form = i / 8 % 2 ? FRICTION_LOG : FRICTION_ASINH;
    return law;
}

/* A material, a slope and what else. */
static void some_slope(uint64_t *seed, int i, const char *products, char *text)
{
    const double a = check_uniform(seed, 0.02, 0.05);

    sprintf(text,
            "material: {a: %.6g, b: %.6g%s}\nslope: {tan_alpha: %.6g}\n"
            "products: [%s]\nbasins: {cells: [8, 8], audit: 4}\n"
            "window: {v: [1e-3, 1e4], psi: [%s]}\n",
            a, a * check_uniform(seed, 1.2, 1.6), i % 8 == 7 ? ", V_c: 3" : "",
            check_uniform(seed, 0.3, 0.4), products,
            i % 8 == 2 || i % 8 == 3 ? "-5, 5" : "1e-2, 1e2");
}

static void states_have_the_same_end(void **state)
{
    static struct push found, exact;
    uint64_t seed = check_seed();

    (void) state;
    for (int i = 0; i < 16; i++) {
        const struct law law = some_law(i);
        char rest[400];
        struct fault why;
        some_slope(&seed, i, "basins", rest);
        struct scene s = as_formulas(&law, rest), t = by_name(&law, rest);
        assert_int_equal(push_init(&found, &s, NULL, &why), STATUS_OK);
        assert_int_equal(push_init(&exact, &t, NULL, &why), STATUS_OK);
        for (int n = 0; n < 4; n++) {
            struct push_state at = {
                exact.slider.block.at.v0 * exp(check_uniform(&seed, -8, 8)), 0
            };
            const double y = check_uniform(&seed, -6, 6);
            at.psi = law_psi_is_log(&law) ? exact.slider.block.at.psi0 + y
                                          : exact.slider.block.at.psi0 * exp(y);
            struct push_answer a, b;
            assert_int_equal(push_find(&found, at, NULL, &a), STATUS_OK);
            assert_int_equal(push_find(&exact, at, NULL, &b), STATUS_OK);
            compare(&a, &b, law.preset);
        }
        push_free(&found);
        push_free(&exact);
        scene_free(&s);
        scene_free(&t);
    }
}

/* ---- maps ---------------------------------------------------------------- */

enum { SIDE = 8, CELLS = SIDE * SIDE };

static void number(double found, double error, double exact, double bar,
                   const char *what, const char *law)
{
    CHECK(isnan(found) == isnan(exact), "%s: %s %g, not %g", law, what, found,
          exact);
    if (!isnan(found))
        CHECK(fabs(found - exact) <= error + bar,
              "%s: %s %.17g +- %g, not %.17g +- %g", law, what, found, error,
              exact, bar);
}

static void compare_maps(const struct study *found, const struct study *exact,
                         const char *law)
{
    static struct cell f[CELLS], e[CELLS];

    static int8_t a[CELLS], b[CELLS];
    assert_int_equal(basin_map_rows(&found->basins, 0, SIDE, a), STATUS_OK);
    assert_int_equal(basin_map_rows(&exact->basins, 0, SIDE, b), STATUS_OK);
    assert_memory_equal(a, b, sizeof a);
    assert_int_equal(found->basins.audit.disagreements, 0);
    for (int k = 0; k < FATES; k++)
        same(&found->basins.fraction[k].log, &exact->basins.fraction[k].log,
             "share", law);
    assert_int_equal(fields_find(&found->fields, 0, SIDE, NULL, f), STATUS_OK);
    assert_int_equal(fields_find(&exact->fields, 0, SIDE, NULL, e), STATUS_OK);
    for (int i = 0; i < CELLS; i++) {
        assert_int_equal(f[i].exit_reason, e[i].exit_reason);
        number(f[i].slip, f[i].slip_error, e[i].slip, e[i].slip_error, "slip",
               law);
        number(f[i].time, f[i].time_error, e[i].time, e[i].time_error, "time",
               law);
        number(f[i].mu_mean, f[i].mu_mean_error, e[i].mu_mean,
               e[i].mu_mean_error, "mu_mean", law);
        number(f[i].v_peak, f[i].v_peak_error, e[i].v_peak, e[i].v_peak_error,
               "v_peak", law);
        number(f[i].mu_peak, f[i].mu_peak_error, e[i].mu_peak,
               e[i].mu_peak_error, "mu_peak", law);
    }
}

static void maps_are_the_same(void **state)
{
    static struct study found, exact;
    uint64_t seed = check_seed() + 1;

    (void) state;
    for (int i = 0; i < 8; i++) {
        const struct law law = some_law(i);
        char rest[400];
        struct fault why;
        some_slope(&seed, i, "basins, slip, time, friction, peak", rest);
        struct scene s = as_formulas(&law, rest), t = by_name(&law, rest);
        assert_int_equal(study_run(&found, &s, NULL, &why), STATUS_OK);
        assert_int_equal(study_run(&exact, &t, NULL, &why), STATUS_OK);
        compare_maps(&found, &exact, law.preset);
        study_free(&found);
        study_free(&exact);
        scene_free(&s);
        scene_free(&t);
    }
}

#define IN_FOLDER(test)                                                        \
    cmocka_unit_test_setup_teardown(test, own_folder_make, own_folder_remove)

int main(void)
{
    const struct CMUnitTest tests[] = {
        IN_FOLDER(states_have_the_same_end),
        IN_FOLDER(maps_are_the_same),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
