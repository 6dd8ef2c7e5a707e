/* Sweeps of systems of formulas: numbers with closed forms, each point the
 * study that its parameters make, reasons where there is none. */
#include <math.h>

#include "number.h"
#include "scene_parameter.h"
#include "sweeps.h"
#include "system.h"

static const struct sweep_options plainly = { .journal = NULL };

#define SWEEP(key, from, to, points)                                           \
    "sweep={key: system.parameters." key ", from: " from ", to: " to           \
    ", points: " points "}"
#define DUFFING                                                                \
    "system.ode=\"x' = y; y' = a*x - x^3 - d*y; a = 1; d = 0.2\"",             \
        "window={x: [-2, 2], y: [-2, 2]}"

static struct quantity number(const struct sweep *s, const char *name, size_t i)
{
    const int k = sweep_find(s, name);

    CHECK(k >= 0, "no column %s", name);
    return sweep_quantity(s, k, i);
}

static void is_near(const struct sweep *s, const char *name, size_t i,
                    double value, double most)
{
    const struct quantity q = number(s, name, i);

    CHECK(quantity_exists(&q), "%s at %zu: %s", name, i, q.reason);
    CHECK(fabs(q.value - value) <= q.error + 2e-16 * fabs(value) &&
              q.error <= most,
          "%s at %zu: %.17g +- %g, expected %.17g +- %g", name, i, q.value,
          q.error, value, most);
}

static void is_word(const struct sweep *s, const char *name, size_t i,
                    const char *word)
{
    const int k = sweep_find(s, name);

    CHECK(k >= 0, "no column %s", name);
    const int code = sweep_code(s, k, i);
    CHECK(code >= 0 && strcmp(s->columns.at[k].codes[code], word) == 0,
          "%s at %zu: %d", name, i, code);
}

/* Saddle +-sqrt(-a), node: one is born with the other. */
static void equilibria_follow_their_closed_form(void **state)
{
    static const char *const sets[] = {
        "system.ode=\"x' = a + x^2; y' = -y; a = 1\"",
        "window={x: [-3, 3], y: [-1, 1]}", SWEEP("a", "-4", "4", "9"), NULL
    };
    struct swept w;

    (void) state;
    sweep_of(&w, sets, &plainly);
    assert_int_equal(w.s.points, 9);
    for (size_t i = 0; i < 9; i++) {
        const double a = (double) i - 4.0, root = sqrt(fmax(-a, 0.0));
        const struct quantity last = number(&w.s, "equilibria_1_state_x", i);
        is_near(&w.s, "count_equilibria", i,
                a < 0.0   ? 2.0
                : a > 0.0 ? 0.0
                          : 1.0,
                0.0);
        if (a < 0.0) {
            is_word(&w.s, "equilibria_0_type", i, "stable_node");
            is_word(&w.s, "equilibria_1_type", i, "saddle");
            is_near(&w.s, "equilibria_0_state_x", i, -root, 1e-15);
            is_near(&w.s, "equilibria_1_state_x", i, root, 1e-15);
            is_near(&w.s, "equilibria_1_eigenvalues_1_re", i, 2.0 * root,
                    1e-14);
            is_near(&w.s, "equilibria_1_eigenvalues_0_re", i, -1.0, 1e-14);
            continue;
        }
        assert_false(quantity_exists(&last));
        assert_string_equal(last.reason, "there are fewer equilibria");
    }
    is_word(&w.s, "equilibria_0_type", 4, "nonhyperbolic");
    assert_int_equal(sweep_find(&w.s, "equilibria_2_state_x"), -1);
    swept_free(&w);
}

static void shares_and_ends_are_numbers_of_points(void **state)
{
    static const char *const sets[] = { DUFFING, "products=[manifolds, basins]",
                                        "basins.audit=10",
                                        SWEEP("d", "0.2", "0.6", "3"), NULL };
    struct swept w;

    (void) state;
    sweep_of(&w, sets, &plainly);
    for (size_t i = 0; i < 3; i++) {
        is_near(&w.s, "equilibria_0_basin_fraction", i, 0.5, 1e-9);
        is_near(&w.s, "equilibria_2_basin_fraction", i, 0.5, 1e-9);
        is_near(&w.s, "basin_infinity", i, 0.0, 1e-9);
        is_word(&w.s, "manifolds_2_end", i, "equilibrium");
        is_near(&w.s, "manifolds_2_to", i, 2.0, 0.0);
        is_near(&w.s, "manifolds_3_to", i, 0.0, 0.0);
    }
    assert_int_equal(sweep_find(&w.s, "equilibria_1_basin_fraction"), -1);
    swept_free(&w);
}

/* x_1 = sqrt a, re = -d/2 at the focus: their derivatives, and what a rounding
 * of a costs x_1: half of it. */
static void derivatives_are_columns_too(void **state)
{
    static const char *const sets[] = {
        DUFFING, "products=[sensitivities]",
        "sweep={key: system.parameters.a, values: [1, 4]}", NULL
    };
    struct swept w;

    (void) state;
    sweep_of(&w, sets, &plainly);
    for (size_t i = 0; i < 2; i++) {
        const double a = i ? 4.0 : 1.0, d = 0.2, root = sqrt(0.25 * d * d + a);
        const struct quantity q = number(&w.s, "equilibria_2_state_x", i);
        is_near(&w.s, "equilibria_2_sensitivities_a_x", i, 0.5 / sqrt(a),
                1e-16);
        is_near(&w.s, "equilibria_2_sensitivities_d_x", i, 0.0, 1e-16);
        is_near(&w.s, "equilibria_2_sensitivities_d_re_0", i, -0.5, 1e-16);
        is_near(&w.s, "equilibria_1_sensitivities_a_re_1", i, 0.5 / root,
                2e-16);
        is_near(&w.s, "equilibria_1_sensitivities_d_re_1", i,
                -0.5 + 0.25 * d / root, 2e-16);
        CHECK(fabs(q.conditioning - 0x1p-54) <= 1e-6 * 0x1p-54, "%g",
              q.conditioning);
    }
    swept_free(&w);
}

/* Where two equilibria cannot be told from one, as where a pitchfork is. */
static void what_is_undecided_has_its_reason(void **state)
{
    static const char *const sets[] = {
        DUFFING, "sweep={key: system.parameters.a, values: [0, 1]}", NULL
    };
    struct swept w;

    (void) state;
    sweep_of(&w, sets, &plainly);
    const struct quantity q = number(&w.s, "equilibria_0_state_x", 0);
    is_near(&w.s, "count_undecided", 0, 1.0, 0.0);
    assert_false(quantity_exists(&q));
    assert_string_equal(q.reason, "not all equilibria could be told apart");
    swept_free(&w);
}

/* The system with --set system.parameters.NAME=DECIMAL. */
static void points_of_a_grid_are_studies(void **state)
{
    static const char *const grid[] = {
        DUFFING, "products=[manifolds]",
        "sweep=[{key: system.parameters.a, from: 0.1, to: 1.3, points: 4}, "
        "{key: system.parameters.d, values: [-0.3, 0.7]}]",
        NULL
    };
    struct swept w, one;

    (void) state;
    sweep_of(&w, grid, &plainly);
    assert_int_equal(w.s.points, 8);
    for (size_t i = 0; i < 8; i++) {
        char set[2][200];
        snprintf(set[0], sizeof set[0], "system.parameters.a=%s",
                 number_shortest(w.s.axis[0].value[i / 2]).text);
        snprintf(set[1], sizeof set[1],
                 "sweep={key: system.parameters.d, values: [%s]}",
                 number_shortest(w.s.axis[1].value[i % 2]).text);
        const char *const sets[] = { DUFFING, "products=[manifolds]", set[0],
                                     set[1], NULL };
        sweep_of(&one, sets, &plainly);
        for (size_t k = 0; k < one.s.columns.count; k++) {
            const char *name = one.s.columns.at[k].name;
            const int at = sweep_find(&w.s, name);
            CHECK(at >= 0, "no column %s", name);
            const struct quantity q = sweep_quantity(&one.s, (int) k, 0),
                                  is = sweep_quantity(&w.s, at, i);
            if (one.s.columns.at[k].codes)
                assert_int_equal(sweep_code(&one.s, (int) k, 0),
                                 sweep_code(&w.s, at, i));
            else
                CHECK(quantity_exists(&q) == quantity_exists(&is) &&
                          (!quantity_exists(&q) ||
                           (q.value == is.value && q.error == is.error)),
                      "%s at %zu: %.17g %.17g", name, i, q.value, is.value);
        }
        swept_free(&one);
    }
    swept_free(&w);
}

static void decimals_are_taken_as_typed(void **state)
{
    static const char *const sets[] = { DUFFING,
                                        "sweep={key: system.parameters.a, "
                                        "values: [0.1, 0.3]}",
                                        NULL };
    static struct formula_system point, typed;
    struct fault why;
    struct scene scene;

    (void) state;
    scene_set(&scene, sets);
    for (size_t i = 0; i < 2; i++) {
        const struct scene_axis *axis = &scene.sweep.axis[0];
        const struct formula_place here = { "", 0, 0 };
        formula_real value;
        point = *scene.system;
        assert_int_equal(scene_parameter_set(&point, axis->key, axis->value[i]),
                         STATUS_OK);
        assert_int_equal(
            formula_parse_decimal(i ? "0.3" : "0.1", here, &value, &why),
            STATUS_OK);
        typed = *scene.system;
        assert_int_equal(formula_system_set(&typed, "a", value, here, &why),
                         STATUS_OK);
        assert_memory_equal(&typed.parameter[0].value,
                            &point.parameter[0].value, sizeof value);
    }
    scene_free(&scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(equilibria_follow_their_closed_form),
        cmocka_unit_test(shares_and_ends_are_numbers_of_points),
        cmocka_unit_test(derivatives_are_columns_too),
        cmocka_unit_test(what_is_undecided_has_its_reason),
        cmocka_unit_test(points_of_a_grid_are_studies),
        cmocka_unit_test(decimals_are_taken_as_typed),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
