/* One slope is asked of the 113-bit oracle once. */
#include "stress_oracle.h"

#include "check.h"

static struct stress_oracle oracle;

static void open_scene(struct scene *scene, const char *law, const char *alpha)
{
    char preset[64], slope[64];
    char *set[] = { preset, slope };
    struct fault why;

    snprintf(preset, sizeof preset, "law.preset=%s", law);
    snprintf(slope, sizeof slope, "slope.alpha=%s", alpha);
    assert_int_equal(scene_read(scene, NULL, set, 2, &why), STATUS_OK);
}

/* What the oracle said last is spoiled, to see whether it is asked again. */
static bool is_asked_again(struct scene *scene)
{
    const size_t spoiled = 7;
    struct stress_row row = { .name = NULL };

    oracle.truth.evaluations = spoiled;
    const struct stress_truth *t = stress_oracle_ask(&oracle, scene, &row);
    assert_int_equal(row.oracle_evaluations, t->evaluations);
    assert_true(row.oracle_seconds >= 0.0);
    return t->evaluations != spoiled;
}

static void one_slope_is_asked_once(void **state)
{
    struct scene scene;

    (void) state;
    open_scene(&scene, "perrin", "0.34");
    oracle = (struct stress_oracle){ .asked = false };
    assert_true(is_asked_again(&scene));
    assert_false(is_asked_again(&scene));
    scene.rtol /= 2.0; /* which truth does not depend on */
    assert_false(is_asked_again(&scene));
    scene_free(&scene);
}

static void another_slope_law_form_or_value_is_asked_anew(void **state)
{
    struct scene scene;

    (void) state;
    open_scene(&scene, "perrin", "0.34");
    oracle = (struct stress_oracle){ .asked = false };
    assert_true(is_asked_again(&scene));
    scene.tan_alpha += 0.01L;
    assert_true(is_asked_again(&scene));
    scene.material.a *= 0.99;
    assert_true(is_asked_again(&scene));
    scene.law.form =
        scene.law.form == FRICTION_LOG ? FRICTION_ASINH : FRICTION_LOG;
    assert_true(is_asked_again(&scene));
    scene.law.theta = THETA_LN_C_PSI;
    assert_true(is_asked_again(&scene));
    scene_free(&scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(one_slope_is_asked_once),
        cmocka_unit_test(another_slope_law_form_or_value_is_asked_anew),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
