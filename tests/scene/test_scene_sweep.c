/* The axes of a sweep, from text to values to scenes. */
#include "scene_sweep.h"

#include <math.h>

#include "scenes.h"
#include "schema.h"
#include "value.h"

#define LAW "law: {preset: spinodal_gen}\n"
#define SET "law.preset=spinodal_gen\n"

static void ranges_are_even_and_end_as_given(void **state)
{
    (void) state;
    for (int is_log = 0; is_log < 2; is_log++) {
        char text[200];
        snprintf(text, sizeof text,
                 LAW "sweep: {key: slope.alpha, from: 0.1, to: 0.7, "
                     "points: 13, scale: %s}\n",
                 is_log ? "log" : "linear");
        struct scene s = scene_made(text, "");
        const struct scene_axis *a = &s.sweep.axis[0];
        assert_int_equal(s.sweep.axes, 1);
        assert_int_equal(a->count, 13);
        assert_true(a->value[0] == 0.1 && a->value[12] == 0.7);
        assert_true(s.alpha == 0.1);
        for (size_t i = 0; i < 12; i++) {
            const double step = is_log ? log(a->value[i + 1] / a->value[i])
                                       : a->value[i + 1] - a->value[i];
            const double even = is_log ? log(7.0) / 12.0 : 0.05;
            CHECK(fabs(step - even) < 1e-14, "step %zu: %g", i, step);
        }
        scene_free(&s);
    }
}

/* From 0.001 k to 0.001 (k + 10 m) in ten steps. */
static void points_between_decimals_are_decimals(void **state)
{
    uint64_t seed = check_seed();

    (void) state;
    for (int i = 0; i < 100; i++) {
        const int k = (int) check_uniform(&seed, 1.0, 500.0);
        const int m = (int) check_uniform(&seed, 1.0, 100.0);
        char text[200];
        snprintf(text, sizeof text,
                 LAW "sweep: {key: slope.alpha, from: %d.%03d, to: %d.%03d, "
                     "points: 11}\n",
                 k / 1000, k % 1000, (k + 10 * m) / 1000, (k + 10 * m) % 1000);
        struct scene s = scene_made(text, "");
        for (int n = 0; n < 11; n++) {
            const double wanted = (double) (k + n * m) / 1000.0;
            CHECK(s.sweep.axis[0].value[n] == wanted, "%.17g, not %.17g",
                  s.sweep.axis[0].value[n], wanted);
        }
        scene_free(&s);
    }
}

static void ends_are_exactly_as_given(void **state)
{
    uint64_t seed = check_seed();

    (void) state;
    for (int i = 0; i < 100; i++) {
        const double from = check_uniform(&seed, 0.1, 0.7);
        const double to = check_uniform(&seed, 0.8, 1.5);
        char sets[200];
        snprintf(sets, sizeof sets,
                 SET "sweep={key: slope.alpha, from: %.17g, to: %.17g, "
                     "points: 3, scale: %s}\n",
                 from, to, i % 2 ? "log" : "linear");
        struct scene s = scene_made(NULL, sets);
        const double *x = s.sweep.axis[0].value;
        CHECK(x[0] == from && x[2] == to, "%.17g %.17g", x[2], to);
        scene_free(&s);
    }
}

static void lists_and_grids_are_as_written(void **state)
{
    struct scene s = scene_made(
        LAW "sweep:\n"
            "- {key: slope.tan_alpha, values: [0.3, 0.35, 0.36]}\n"
            "- {key: material.c, from: 1e-4, to: 1, points: 5, scale: log}\n",
        "");

    (void) state;
    assert_int_equal(s.sweep.axes, 2);
    assert_int_equal(s.sweep.axis[0].count, 3);
    assert_true(s.sweep.axis[0].value[1] == 0.35);
    assert_string_equal(s.sweep.axis[1].key, "material.c");
    assert_int_equal(s.sweep.axis[1].count, 5);
    assert_true(scene_sweeps(&s, "material.c"));
    assert_false(scene_sweeps(&s, "material.a"));
    scene_free(&s);
    s = scene_made(LAW "slope: {alpha: 0.3}\nsweep: {}\n", "");
    assert_int_equal(s.sweep.axes, 0);
    scene_free(&s);
}

static void keys_of_a_sweep_can_be_overridden_one_by_one(void **state)
{
    struct scene s = scene_made(
        LAW "sweep: {key: slope.alpha, from: 0.1, to: 0.7, points: 13}\n",
        "sweep.points=3\nsweep.to=0.5\n");

    (void) state;
    assert_int_equal(s.sweep.axis[0].count, 3);
    assert_true(s.sweep.axis[0].value[2] == 0.5);
    scene_free(&s);
    s = scene_made(
        LAW "sweep: {key: slope.alpha, from: 0.1, to: 0.7, points: 13}\n",
        "sweep.values=[0.2]\nsweep.from=0.3\nsweep.to=0.4\n"
        "sweep.points=2\n");
    assert_int_equal(s.sweep.axis[0].count, 2);
    scene_free(&s);
}

static void what_is_swept_need_not_be_given(void **state)
{
    struct scene s =
        scene_made("law: {preset: kato_tullis}\nslope: {alpha: 0.4}\n"
                   "sweep: {key: material.V_c, values: [3, 4]}\n",
                   "");

    (void) state;
    assert_true(s.material.V_c == 3.0);
    scene_free(&s);
    s = scene_made(
        LAW "slope: {alpha: 0.4}\nsweep: {key: slope.alpha, values: [0.3]}\n",
        "");
    assert_true(s.alpha == 0.4);
    scene_free(&s);
}

/* Bit for bit, for every key that can be swept. */
static void a_point_is_the_scene_that_set_makes(void **state)
{
    (void) state;
    for (const struct schema_key *k = schema_table; k->path; k++) {
        if (!value_is_real(k) || strcmp(k->path, "material.V_c") == 0)
            continue;
        const double x = strcmp(k->path, "accuracy.rtol") == 0 ||
                                 strcmp(k->path, "basins.rtol") == 0
                             ? 1e-3
                             : 0.37;
        char sweep[200], set[200];
        const char *slope =
            strncmp(k->path, "slope.", 6) == 0 ? "" : "slope.alpha=0.3\n";
        snprintf(sweep, sizeof sweep,
                 SET "%ssweep={key: %s, values: [%g, %.17g]}\n", slope, k->path,
                 x / 2, x);
        snprintf(set, sizeof set, SET "%s%s=%.17g\n", slope, k->path, x);
        struct scene s = scene_made(NULL, sweep), is = scene_made(NULL, set);
        struct scene point;
        scene_at(&s, &s.sweep.axis[0].value[1], &point);
        point.sweep = is.sweep;
        point.spring_block = is.spring_block; /* no point of a sweep uses it */
        CHECK(scene_same(&point, &is), "%s", k->path);
        scene_free(&s);
        scene_free(&is);
    }
}

#define IN_FOLDER(test)                                                        \
    cmocka_unit_test_setup_teardown(test, own_folder_make, own_folder_remove)

int main(void)
{
    const struct CMUnitTest tests[] = {
        IN_FOLDER(ranges_are_even_and_end_as_given),
        IN_FOLDER(points_between_decimals_are_decimals),
        IN_FOLDER(ends_are_exactly_as_given),
        IN_FOLDER(lists_and_grids_are_as_written),
        IN_FOLDER(keys_of_a_sweep_can_be_overridden_one_by_one),
        IN_FOLDER(what_is_swept_need_not_be_given),
        IN_FOLDER(a_point_is_the_scene_that_set_makes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
