/* Scenes without a slope: those that may be, and the line of the others. */
#include "scene_slope.h"

#include <string.h>

#include "scenes.h"
#include "study.h"

#define LAW "law: {preset: spinodal_gen}\n"

static bool is_slopeless(int p)
{
    return p == PRODUCT_FOLDS || p >= PRODUCT_FRICTION_LAW;
}

static void a_scene_needs_a_slope_where_a_product_takes_one(void **state)
{
    (void) state;
    for (int p = 0; p < PRODUCTS; p++) {
        char text[200], line[200];
        struct scene s;
        struct fault why;
        snprintf(text, sizeof text, LAW "products: [folds,\n  %s]\n",
                 product_names[p]);
        snprintf(line, sizeof line,
                 "s.yaml:3:3: products: no slope for %s, expected 'slope: "
                 "{alpha: RAD}' or --alpha RAD",
                 product_names[p]);
        const enum status status = scene_of(&s, text, "", &why);
        if (is_slopeless(p)) {
            assert_int_equal(status, STATUS_OK);
            assert_false(scene_has_slope(&s));
            scene_free(&s);
            continue;
        }
        assert_int_equal(status, STATUS_BAD_SCENE);
        const char *from = strstr(why.text, "s.yaml");
        assert_non_null(from);
        assert_string_equal(from, line);
        strcat(text, "slope: {tan_alpha: 0.3}\n");
        assert_int_equal(scene_of(&s, text, "", &why), STATUS_OK);
        assert_true(scene_has_slope(&s));
        scene_free(&s);
    }
}

static void a_swept_slope_is_one(void **state)
{
    struct scene s = scene_made(
        LAW "products: [knees]\nsweep: {key: slope.alpha, values: [0.3]}\n",
        "");

    (void) state;
    assert_true(scene_has_slope(&s));
    scene_free(&s);
    s = scene_made(
        LAW "products: [folds]\nsweep: {key: material.c, values: [0.3]}\n", "");
    assert_false(scene_has_slope(&s));
    scene_free(&s);
}

static void an_experiment_may_have_its_own_slopes(void **state)
{
    struct scene s =
        scene_made(LAW "rabinowicz: {tan_alpha: [0.3, 0.35]}\n", "");
    struct fault why;

    (void) state;
    assert_false(scene_has_slope(&s));
    scene_free(&s);
    assert_int_equal(
        scene_of(&s, LAW "rabinowicz: {restitution: 0.5}\n", "", &why),
        STATUS_BAD_SCENE);
    assert_non_null(strstr(why.text, "s.yaml:1:1: no slope, expected"));
}

static void a_product_added_later_is_refused_by_name(void **state)
{
    struct scene s = scene_made(LAW "products: [bifurcation]\n", "");
    struct study study;
    struct fault why;

    (void) state;
    s.products |= 1u << PRODUCT_KNEES;
    assert_int_equal(study_run(&study, &s, NULL, &why), STATUS_BAD_SCENE);
    assert_non_null(strstr(why.text,
                           "s.yaml: no slope for knees, expected 'slope: "
                           "{alpha: RAD}' or --alpha RAD"));
    scene_free(&s);
    s = scene_made(NULL, "law.preset=ruina\nproducts=[folds]\n");
    s.products |= 1u << PRODUCT_TIME;
    assert_int_equal(study_run(&study, &s, NULL, &why), STATUS_BAD_SCENE);
    assert_non_null(strstr(why.text, "command line: no slope for time"));
    scene_free(&s);
}

/* The slope plays no part in it. */
static void a_diagram_is_the_same_with_a_slope_and_without(void **state)
{
    struct scene without = scene_made(LAW "products: [bifurcation]\n", "");
    struct scene with =
        scene_made(LAW "products: [bifurcation]\nslope: {alpha: 0.34}\n", "");
    struct study a, b;
    struct fault why;

    (void) state;
    assert_int_equal(study_run(&a, &without, NULL, &why), STATUS_OK);
    assert_int_equal(study_run(&b, &with, NULL, &why), STATUS_OK);
    const struct steady_curve *c = &a.diagrams.bifurcation;
    const struct steady_curve *d = &b.diagrams.bifurcation;
    assert_int_equal(c->count, d->count);
    for (size_t i = 0; i < c->count; i++)
        assert_true(c->at[i].v == d->at[i].v &&
                    c->at[i].mu.value == d->at[i].mu.value &&
                    c->at[i].lambda_plus.value == d->at[i].lambda_plus.value);
    assert_true(c->count > 100);
    assert_false(plan_has(a.stages, STAGE_STEADY));
    assert_int_equal(a.slider.plane.equilibria, 0);
    assert_int_equal(b.slider.plane.equilibria, 3);
    study_free(&a);
    study_free(&b);
    scene_free(&without);
    scene_free(&with);
}

#define IN_FOLDER(test)                                                        \
    cmocka_unit_test_setup_teardown(test, own_folder_make, own_folder_remove)

int main(void)
{
    const struct CMUnitTest tests[] = {
        IN_FOLDER(a_scene_needs_a_slope_where_a_product_takes_one),
        IN_FOLDER(a_swept_slope_is_one),
        IN_FOLDER(an_experiment_may_have_its_own_slopes),
        IN_FOLDER(a_product_added_later_is_refused_by_name),
        IN_FOLDER(a_diagram_is_the_same_with_a_slope_and_without),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
