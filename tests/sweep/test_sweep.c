/* Sweeps: each point a study of its own, in any order, refined, resumed. */
#include "sweep.h"

#include <math.h>
#include <omp.h>

#include "failing_study.h"
#include "fault_alloc.h"
#include "own_folder.h"
#include "sweeps.h"

static const struct sweep_options plainly = { .journal = NULL };

#define LAW "law.preset=spinodal_gen"
#define ALL "products=[equilibria, folds, knees, estimates]"

/* ---- points -------------------------------------------------------------- */

/* The study that a user gets from --set KEY=VALUE. */
static void check_point(const struct sweep *s, size_t i, const char *law,
                        const char *key)
{
    const double nowhere[2] = { 0.0, 0.0 };
    const size_t values = s->axis[0].count;
    struct sweep_point point;
    struct scene scene;
    char set[200];

    assert_int_equal(s->points, values);
    snprintf(set, sizeof set, "%s=%.17g", key, s->axis[0].value[i]);
    const char *const slope =
        strncmp(key, "slope.", 6) == 0 ? "title=none" : "slope.alpha=0.34";
    const char *const sets[] = { law, ALL, slope, set, NULL };
    scene_set(&scene, sets);
    assert_int_equal(
        sweep_point_at(&point, &scene, nowhere, scene.products, NULL),
        STATUS_OK);
    for (size_t k = 0; k < s->columns.count; k++) {
        const struct sweep_column *c = &s->columns.at[k];
        if (c->codes) {
            assert_int_equal(sweep_code(s, (int) k, i),
                             sweep_column_code(c, &point, 0));
            continue;
        }
        const struct quantity q = sweep_quantity(s, (int) k, i);
        const struct quantity is = sweep_column_quantity(c, &point, 0);
        CHECK(quantity_exists(&q) == quantity_exists(&is), "%s", c->name);
        if (quantity_exists(&q))
            CHECK(q.value == is.value && q.error == is.error, "%s: %.17g %.17g",
                  c->name, q.value, is.value);
        else
            assert_string_equal(q.reason, is.reason);
    }
    sweep_point_free(&point);
    scene_free(&scene);
}

static void every_point_is_the_study_of_its_scene(void **state)
{
    static const struct {
        const char *law, *key, *range[3];
    } of[] = {
        { LAW, "slope.alpha", { "0.28", "0.39", "linear" } },
        { LAW, "slope.alpha_deg", { "17", "22", "linear" } },
        { LAW, "slope.tan_alpha", { "0.31", "0.4", "log" } },
        { "law.preset=dieterich_gen", "material.a", { "0.01", "0.06", "log" } },
        { LAW, "material.c", { "1e-4", "10", "log" } },
        { "law.preset=ruina", "gravity", { "1", "20", "linear" } },
        { "law.preset=dieterich", "accuracy.rtol", { "1e-13", "1e-6", "log" } },
    };

    (void) state;
    for (size_t i = 0; i < sizeof of / sizeof *of; i++) {
        char key[80], from[80], to[80], scale[80];
        snprintf(key, sizeof key, "sweep.key=%s", of[i].key);
        snprintf(from, sizeof from, "sweep.from=%s", of[i].range[0]);
        snprintf(to, sizeof to, "sweep.to=%s", of[i].range[1]);
        snprintf(scale, sizeof scale, "sweep.scale=%s", of[i].range[2]);
        const char *const slope = strncmp(of[i].key, "slope.", 6) == 0
                                      ? "title=none"
                                      : "slope.alpha=0.34";
        const char *const sets[] = {
            of[i].law, ALL, slope, key, from, to, "sweep.points=4", scale, NULL
        };
        struct swept w;
        sweep_of(&w, sets, &plainly);
        for (size_t k = 0; k < 4; k++)
            check_point(&w.s, k, of[i].law, of[i].key);
        swept_free(&w);
    }
}

static const char *const slopes[] = {
    LAW,
    ALL,
    "sweep={key: slope.alpha, from: 0.28, to: 0.4, points: 60}",
    NULL,
};

static void any_number_of_threads_gives_the_same_bits(void **state)
{
    static const char *const refined[] = {
        LAW, ALL,
        "sweep={key: slope.alpha, from: 0.28, to: 0.4, points: 9, refine: 0.1}",
        NULL
    };
    struct swept one, many;

    (void) state;
    for (int i = 0; i < 2; i++) {
        const char *const *sets = i ? refined : slopes;
        omp_set_num_threads(1);
        sweep_of(&one, sets, &plainly);
        for (int threads = 2; threads <= 4; threads += 2) {
            omp_set_num_threads(threads);
            sweep_of(&many, sets, &plainly);
            sweeps_are_the_same(&one.s, &many.s);
            swept_free(&many);
        }
        swept_free(&one);
    }
}

static void a_grid_runs_the_second_key_fastest(void **state)
{
    static const char *const sets[] = {
        LAW, "products=[knees]",
        "sweep=[{key: slope.alpha, values: [0.33, 0.35, 0.36]},"
        "{key: material.a, from: 0.02, to: 0.03, points: 2}]",
        NULL
    };
    struct swept w;

    (void) state;
    sweep_of(&w, sets, &plainly);
    assert_int_equal(w.s.axes, 2);
    assert_int_equal(w.s.points, 6);
    assert_string_equal(w.s.axis[1].name, "a");
    for (size_t i = 0; i < 6; i++) {
        const double x[] = { w.s.axis[0].value[i / 2],
                             w.s.axis[1].value[i % 2] };
        struct scene point;
        struct study study;
        struct fault why;
        scene_at(&w.scene, x, &point);
        assert_true(point.alpha == x[0] && point.material.a == x[1]);
        assert_int_equal(study_run(&study, &point, NULL, &why), STATUS_OK);
        const struct quantity q =
            sweep_quantity(&w.s, sweep_find(&w.s, "v_plus"), i);
        assert_true(q.value == study.slider.critical.v_plus.value);
        study_free(&study);
    }
    swept_free(&w);
}

static void what_is_missing_says_why(void **state)
{
    struct swept w;

    (void) state;
    sweep_of(&w, slopes, &plainly);
    const int v_plus = sweep_find(&w.s, "v_plus");
    const struct quantity first = sweep_quantity(&w.s, v_plus, 0);
    const struct quantity there = sweep_quantity(&w.s, v_plus, 30);
    assert_string_equal(first.reason, "there is no saddle at this slope");
    assert_true(isnan(first.value) && isnan(first.error));
    assert_true(quantity_exists(&there) && there.error > 0.0);
    assert_string_equal(w.s.reasons.word[sweep_code(&w.s, v_plus, 0)],
                        "there_is_no_saddle_at_this_slope");
    assert_int_equal(sweep_code(&w.s, v_plus, 30), REASON_PRESENT);
    assert_int_equal(sweep_code(&w.s, sweep_find(&w.s, "upper_end"), 0), -1);
    assert_int_equal(sweep_find(&w.s, "no_such_number"), -1);
    assert_int_equal(w.s.failed, 0);
    swept_free(&w);
}

static void only_what_the_products_ask_for_is_there(void **state)
{
    static const char *const sets[] = {
        LAW, "products=[folds]",
        "sweep={key: material.c, values: [1e-3, 1e-2]}", "slope.alpha=0.34",
        NULL
    };
    static const char *const level[] = {
        LAW, "products=[folds]",
        "sweep={key: material.c, values: [1e-3, 1e-2]}", NULL
    };
    static const char *const asked[] = {
        LAW, "products=[knees, sensitivities]",
        "sweep={key: slope.alpha, values: [0.34, 0.345]}", NULL
    };
    struct swept w;

    (void) state;
    sweep_of(&w, sets, &plainly);
    assert_int_equal(sweep_find(&w.s, "v_plus"), -1);
    assert_true(sweep_find(&w.s, "folds_alpha_cM") >= 0);
    assert_true(sweep_find(&w.s, "equilibria_2_v") >= 0);
    assert_int_equal(sweep_find(&w.s, "equilibria_3_v"), -1);
    assert_false(w.s.columns.conditioning);
    assert_int_equal(sweep_find(&w.s, "creep_ln_v"), -1);
    swept_free(&w);
    sweep_of(&w, level, &plainly);
    assert_int_equal(w.s.columns.count, record_folds.count);
    assert_string_equal(w.s.columns.at[0].name, "folds_alpha_cm");
    swept_free(&w);
    sweep_of(&w, asked, &plainly);
    assert_true(w.s.columns.conditioning);
    assert_true(
        sweep_quantity(&w.s, sweep_find(&w.s, "v_plus"), 0).conditioning > 0.0);
    assert_true(sweep_find(&w.s, "sensitivities_v_plus_alpha") >= 0);
    swept_free(&w);
}

/* ---- refinement ---------------------------------------------------------- */

static struct quantity number_at(const struct scene *scene, double alpha,
                                 bool plus)
{
    struct scene point;
    struct study study;
    struct fault why;

    scene_at(scene, &alpha, &point);
    assert_int_equal(study_run(&study, &point, NULL, &why), STATUS_OK);
    const struct quantity q = plus ? study.slider.critical.ln_v_plus
                                   : study.slider.critical.ln_v_minus;
    study_free(&study);
    return q;
}

/* Anywhere between two points that are there the chord is as near as was
 * asked for, and so is the last point to the fold. */
static void a_refined_curve_is_within_its_tolerance(void **state)
{
    enum { TRIES = 60 };
    static const char *const sets[] = {
        LAW, "products=[folds, knees]",
        "sweep={key: slope.alpha, from: 0.28, to: 0.4, points: 7, "
        "refine: 0.02}",
        NULL
    };
    uint64_t seed = check_seed();
    struct swept w;

    (void) state;
    sweep_of(&w, sets, &plainly);
    const struct sweep *s = &w.s;
    assert_false(s->unrefined);
    const double fold[] = {
        sweep_quantity(s, sweep_find(s, "folds_alpha_cm"), 0).value,
        sweep_quantity(s, sweep_find(s, "folds_alpha_cM"), 0).value
    };
    for (int plus = 0; plus < 2; plus++) {
        const int column = sweep_find(s, plus ? "ln_v_plus" : "ln_v_minus");
        size_t lo = 0, hi = s->points - 1;
        while (sweep_code(s, column, lo) != REASON_PRESENT)
            lo++;
        while (sweep_code(s, column, hi) != REASON_PRESENT)
            hi--;
        const double *x = s->axis[0].value;
        for (int i = 0; i < TRIES; i++) {
            const double at = check_uniform(&seed, x[lo], x[hi]);
            size_t k = lo;
            while (x[k + 1] < at)
                k++;
            const double t = (at - x[k]) / (x[k + 1] - x[k]);
            const double chord =
                (1.0 - t) * sweep_quantity(s, column, k).value +
                t * sweep_quantity(s, column, k + 1).value;
            const double off =
                fabs(chord - number_at(&w.scene, at, plus).value);
            CHECK(off <= 0.02, "alpha %.17g: %g off the chord", at, off);
        }
        const double near[] = { fold[0] * (1.0 + 1e-10),
                                fold[1] * (1.0 - 1e-10) };
        const size_t last[] = { lo, hi };
        for (int k = 0; k < 2; k++) {
            const double left = fabs(sweep_quantity(s, column, last[k]).value -
                                     number_at(&w.scene, near[k], plus).value);
            CHECK(left <= 0.02, "fold %d, plus %d: %g left", k, plus, left);
        }
    }
    swept_free(&w);
}

static void a_coarser_tolerance_keeps_fewer_points(void **state)
{
    static const char *const tol[] = { "sweep.refine=1", "sweep.refine=0.1",
                                       "sweep.refine=0.01" };
    size_t before = 8;

    (void) state;
    for (int i = 0; i < 3; i++) {
        const char *const sets[] = {
            LAW, "products=[knees]",
            "sweep={key: slope.alpha, from: 0.28, to: 0.4, points: 7}", tol[i],
            NULL
        };
        struct swept w;
        sweep_of(&w, sets, &plainly);
        CHECK(w.s.points > before && w.s.points < 400, "%zu points",
              w.s.points);
        before = w.s.points;
        for (size_t k = 0; k + 1 < w.s.points; k++)
            assert_true(w.s.axis[0].value[k] < w.s.axis[0].value[k + 1]);
        swept_free(&w);
    }
}

/* ---- failures ------------------------------------------------------------ */

static void each_failed_allocation_is_told(void **state)
{
    static const char *const sets[] = {
        LAW, "products=[folds, knees]",
        "sweep={key: slope.alpha, values: [0.33, 0.34], refine: 0.9}", NULL
    };
    const struct sweep_options o = { .journal = own_path("a.part"),
                                     .resume = true,
                                     .version = "1" };
    enum status status = STATUS_NO_MEMORY;
    struct scene scene;
    struct sweep s;
    struct fault why;

    (void) state;
    scene_set(&scene, sets);
    omp_set_num_threads(1);
    for (long k = 0; status != STATUS_OK; k++) {
        sweep_forget(o.journal);
        fault_alloc_at(k);
        status = sweep_run(&s, &scene, &o, NULL, &why);
        fault_alloc_at(FAULT_ALLOC_NEVER);
        CHECK(status == STATUS_OK || status == STATUS_NO_MEMORY, "%ld: %s", k,
              why.text);
        if (status == STATUS_NO_MEMORY)
            assert_string_equal(why.text, "out of memory");
    }
    assert_int_equal(s.failed, 0);
    sweep_free(&s);
    sweep_free(&s);
    scene_free(&scene);
}

/* Those in the middle are computed last. */
static void reasons_are_numbered_from_the_first_point_to_the_last(void **state)
{
    static const char *const sets[] = {
        LAW, "products=[knees]",
        "sweep={key: slope.alpha, values: [0.3, 0.4], refine: 0.2}", NULL
    };
    struct swept w;

    (void) state;
    failing_slopes[0] = 0.34;
    failing_slopes[1] = 0.36;
    sweep_of(&w, sets, &plainly);
    failing_slopes[0] = failing_slopes[1] = 0.0;
    const int v_plus = sweep_find(&w.s, "v_plus");
    const int last = sweep_code(&w.s, v_plus, w.s.points - 1);
    size_t i = 0;
    while (sweep_code(&w.s, v_plus, i) == REASON_PRESENT)
        i++;
    const int first = sweep_code(&w.s, v_plus, i);
    CHECK(w.s.axis[0].value[i] < 0.36 && first < last, "%.17g: codes %d, %d",
          w.s.axis[0].value[i], first, last);
    assert_true(w.s.failed > 0);
    assert_string_equal(w.s.reasons.word[last],
                        "there_is_no_saddle_at_this_slope");
    swept_free(&w);
}

static void a_failed_point_costs_only_itself(void **state)
{
    struct swept w;

    (void) state;
    failing_slopes[1] = 0.3;
    sweep_of(&w, slopes, &plainly);
    failing_slopes[1] = 0.0;
    assert_int_equal(w.s.failed, 10);
    for (size_t i = 0; i < w.s.points; i++)
        for (size_t k = 0; k < w.s.columns.count; k++) {
            if (w.s.columns.at[k].codes)
                continue;
            const struct quantity q = sweep_quantity(&w.s, (int) k, i);
            CHECK((i < 10) ==
                      (q.reason && strcmp(q.reason, "iteration stopped before "
                                                    "its tolerance") == 0),
                  "%s of point %zu", w.s.columns.at[k].name, i);
        }
    swept_free(&w);
}

#define IN_FOLDER(test)                                                        \
    cmocka_unit_test_setup_teardown(test, own_folder_make, own_folder_remove)

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_point_is_the_study_of_its_scene),
        cmocka_unit_test(any_number_of_threads_gives_the_same_bits),
        cmocka_unit_test(a_grid_runs_the_second_key_fastest),
        cmocka_unit_test(what_is_missing_says_why),
        cmocka_unit_test(only_what_the_products_ask_for_is_there),
        cmocka_unit_test(a_refined_curve_is_within_its_tolerance),
        cmocka_unit_test(a_coarser_tolerance_keeps_fewer_points),
        IN_FOLDER(each_failed_allocation_is_told),
        cmocka_unit_test(reasons_are_numbered_from_the_first_point_to_the_last),
        cmocka_unit_test(a_failed_point_costs_only_itself),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
