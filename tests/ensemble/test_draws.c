/* Draws by their laws: closed forms of moments, nets, bytes. */
#include "draws.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include <gsl/gsl_cdf.h>

#include "ensemble_tolerance.h"
#include "fault_alloc.h"
#include "normal.h"
#include "own_folder.h"
#include "sweeps.h"

static void test_normal_quantiles_are_those_of_the_normal_law(void **state)
{
    uint64_t rng = check_seed();

    (void) state;
    for (int i = 0; i < 20000; i++) {
        const double p = i % 2 ? check_uniform(&rng, 1e-9, 1.0)
                               : pow(10.0, check_uniform(&rng, -300.0, -1.0));
        const double z = normal_quantile(p), back = gsl_cdf_ugaussian_P(z);
        /* d ln P/dz is about |z| in the tail */
        CHECK(fabs(back / p - 1.0) <= 4e-14 * (1.0 + z * z), "p = %g: %.17g", p,
              z);
    }
    assert_true(normal_quantile(0.5) == 0.0);
    assert_true(normal_quantile(0.25) == -normal_quantile(0.75));
}

static void test_scrambled_points_are_nets(void **state)
{
    enum { POINTS = 1024, DIMENSIONS = 5 };
    struct sobol s;

    (void) state;
    assert_int_equal(sobol_init(&s, DIMENSIONS, POINTS), STATUS_OK);
    for (uint64_t seed = 1; seed < 4; seed++)
        for (size_t d = 0; d < DIMENSIONS; d++)
            for (size_t from = 0; from < POINTS; from += 256) {
                /* of 256 in a row one in each of 256 intervals */
                unsigned char met[256] = { 0 };
                for (size_t i = from; i < from + 256; i++) {
                    const double u = sobol_at(&s, i, d, seed);
                    assert_true(u > 0.0 && u < 1.0);
                    met[(size_t) (256 * u)]++;
                }
                for (int i = 0; i < 256; i++)
                    CHECK(met[i] == 1, "seed %d, dimension %zu, interval %d",
                          (int) seed, d, i);
            }
    /* and of the first two dimensions one in each square of side 1/32 */
    unsigned char met[32][32] = { { 0 } };
    for (size_t i = 0; i < POINTS; i++)
        met[(size_t) (32 * sobol_at(&s, i, 0, 7))]
           [(size_t) (32 * sobol_at(&s, i, 1, 7))]++;
    for (int i = 0; i < 32; i++)
        for (int j = 0; j < 32; j++)
            CHECK(met[i][j] == 1, "square %d, %d", i, j);
}

static void test_scramblings_differ_and_have_no_bias(void **state)
{
    struct sobol s;
    double mean = 0.0;

    (void) state;
    assert_int_equal(sobol_init(&s, 2, 16), STATUS_OK);
    for (uint64_t seed = 0; seed < 4000; seed++)
        mean += sobol_at(&s, 3, 1, seed) / 4000.0;
    CHECK(fabs(mean - 0.5) < 4.0 / sqrt(12.0 * 4000.0), "%g", mean);
    assert_true(sobol_at(&s, 3, 1, 1) != sobol_at(&s, 3, 1, 2));
}

static const char *write_own(const char *name, const char *text)
{
    file_write(own_path(name), text, strlen(text));
    return own_path(name);
}

/* ---- of scenes ----------------------------------------------------------- */

enum { KEYS = 3 };

struct drawn {
    struct scene scene;
    struct draws d;
    double *column[SCENE_SPREADS];
};

static void open_draws(struct drawn *x, const char *ensemble)
{
    char text[400];
    const char *const sets[] = { "law.preset=spinodal_gen", "slope.alpha=0.34",
                                 text, NULL };
    struct fault why;

    snprintf(text, sizeof text, "ensemble={%s}", ensemble);
    scene_set(&x->scene, sets);
    CHECK(draws_init(&x->d, &x->scene, &why) == STATUS_OK, "%s", why.text);
    for (size_t k = 0; k < x->d.keys; k++) {
        x->column[k] = malloc(x->d.count * sizeof(double));
        assert_non_null(x->column[k]);
    }
    draws_fill(&x->d, 0, x->d.count, x->column);
}

static void close_draws(struct drawn *x)
{
    for (size_t k = 0; k < x->d.keys; k++)
        free(x->column[k]);
    draws_free(&x->d);
    scene_free(&x->scene);
}

static double mean_of(const double x[], size_t n)
{
    double sum = 0.0;

    for (size_t i = 0; i < n; i++)
        sum += x[i];
    return sum / (double) n;
}

static double covariance_of(const double x[], const double y[], size_t n)
{
    const double mx = mean_of(x, n), my = mean_of(y, n);
    double sum = 0.0;

    for (size_t i = 0; i < n; i++)
        sum += (x[i] - mx) * (y[i] - my);
    return sum / (double) (n - 1);
}

static const char three[] =
    "parameters: {material.a: {normal: [0.03, 0.001]}, material.b: {uniform: "
    "[0.04, 0.06]}, material.L: {lognormal: [1e-6, 2]}}, draws: 40000, "
    "method: %s, seed: 3";

static void test_moments_are_those_of_the_laws(void **state)
{
    static const char *const method[] = { "sobol", "random", "grid" };

    (void) state;
    for (int m = 0; m < 3; m++) {
        struct drawn x;
        char text[400];
        snprintf(text, sizeof text, three, method[m]);
        open_draws(&x, text);
        const size_t n = x.d.count;
        const double root = 5.0 / sqrt((double) n), grid = m == 2 ? 0.03 : 0.0;
        CHECK(m < 2 ? n == 40000 : n == 34 * 34 * 34, "%zu", n);
        for (size_t i = 0; i < n; i++)
            x.column[2][i] = log(x.column[2][i]);
        CHECK(fabs(mean_of(x.column[0], n) - 0.03) < 1e-3 * root, "%s: %g",
              method[m], mean_of(x.column[0], n));
        CHECK(fabs(mean_of(x.column[1], n) - 0.05) < 0.006 * root, "%s: %g",
              method[m], mean_of(x.column[1], n));
        CHECK(fabs(mean_of(x.column[2], n) - log(1e-6)) < log(2.0) * root,
              "%s: %g", method[m], mean_of(x.column[2], n));
        for (int k = 0; k < 3; k++) {
            static const double variance[] = { 1e-6, 4e-4 / 12.0,
                                               0.4804530139182014 };
            const double v = covariance_of(x.column[k], x.column[k], n);
            CHECK(fabs(v / variance[k] - 1.0) < 1.5 * root + grid, "%s: %d: %g",
                  method[m], k, v);
        }
        const double c = covariance_of(x.column[0], x.column[1], n);
        CHECK(fabs(c) < root * 1e-3 * 0.006, "%s: %g", method[m], c);
        close_draws(&x);
    }
}

static void test_any_block_is_a_part_of_the_whole(void **state)
{
    static const char *const method[] = { "sobol", "random", "grid" };
    uint64_t rng = check_seed();

    (void) state;
    for (int m = 0; m < 3; m++) {
        struct drawn x;
        char text[400];
        double part[KEYS][100], *column[] = { part[0], part[1], part[2] };
        snprintf(text, sizeof text, three, method[m]);
        open_draws(&x, text);
        for (int i = 0; i < 50; i++) {
            const size_t first =
                (size_t) check_uniform(&rng, 0.0, (double) (x.d.count - 100));
            draws_fill(&x.d, first, 100, column);
            for (int k = 0; k < KEYS; k++)
                assert_memory_equal(part[k], x.column[k] + first,
                                    sizeof part[k]);
        }
        close_draws(&x);
    }
}

static void test_a_covariance_is_met(void **state)
{
    const char *path = write_own("c.csv", "key,mean,material.b,material.a\n"
                                          "material.a,0.03,0.6e-6,1e-6\n"
                                          "material.b,0.05,4e-6,0.6e-6\n");
    char text[400];
    struct drawn x;

    (void) state;
    snprintf(text, sizeof text, "covariance: %s, draws: 40000", path);
    open_draws(&x, text);
    assert_int_equal(x.d.keys, 2);
    const size_t n = x.d.count;
    CHECK(fabs(mean_of(x.column[0], n) - 0.03) < 1e-6, "%g",
          mean_of(x.column[0], n));
    CHECK(fabs(covariance_of(x.column[0], x.column[0], n) - 1e-6) < 2e-8, "%g",
          covariance_of(x.column[0], x.column[0], n));
    CHECK(fabs(covariance_of(x.column[0], x.column[1], n) - 0.6e-6) < 2e-8,
          "%g", covariance_of(x.column[0], x.column[1], n));
    CHECK(fabs(covariance_of(x.column[1], x.column[1], n) - 4e-6) < 8e-8, "%g",
          covariance_of(x.column[1], x.column[1], n));
    close_draws(&x);
}

static void test_samples_are_the_rows_of_their_file(void **state)
{
    const char *path =
        write_own("s.csv", "# measured\n"
                           "id,material.L [m],slope.alpha\n"
                           "north,1e-6,0.33\n\"south, 2\",2e-6,0.35\n");
    char text[400];
    struct drawn x;

    (void) state;
    snprintf(text, sizeof text, "samples: %s", path);
    open_draws(&x, text);
    assert_int_equal(x.d.count, 2);
    assert_string_equal(x.d.key[0], "material.L");
    assert_string_equal(x.d.key[1], "slope.alpha");
    assert_string_equal(draws_id(&x.d, 1), "south, 2");
    assert_true(x.column[0][0] == 1e-6 && x.column[1][1] == 0.35);
    close_draws(&x);
}

/* ---- wrong files --------------------------------------------------------- */

static const struct {
    const char *kind, *text, *said;
} wrong[] = {
    { "samples", "material.a,id\nx,1\n",
      ":2:1: material.a: 'x' is not allowed, expected a number > 0" },
    { "samples", "id,material.a\n1,0.03\n2,-1\n",
      ":3:3: material.a: '-1' is not allowed, expected a number > 0" },
    { "samples", "id,material.a\n1,\n",
      ":2:3: material.a: '' is not allowed, expected a number > 0" },
    { "samples", "material.a,material.q\n0.03,1\n",
      ":1:12: 'material.q' is no key of a number, expected one such as "
      "material.a" },
    { "samples", "material.L [um]\n1\n",
      ":1:1: material.L: unit 'um', expected m" },
    { "samples", "material.V_c\n1\n", ":1:1: material.V_c: not used by this" },
    { "samples", "slope.alpha,slope.tan_alpha\n0.3,0.3\n",
      ":1:13: slope.tan_alpha beside slope.alpha, expected one" },
    { "samples", "id\n1\n", ":1:1: no column of a key" },
    { "samples", "id,material.a\n1\n", ":2:1: 1 cells, the header has 2" },
    { "covariance", "key,material.a\nmaterial.a,1e-6\n",
      ":1:1: no column 'mean', expected key, mean and one for each key" },
    { "covariance", "key,mean\nmaterial.a,1\n",
      ":1:1: no column 'material.a', expected key, mean" },
    { "covariance",
      "key,mean,material.a,material.b\nmaterial.a,0.03,1,0\n"
      "material.b,0.05,1,1\n",
      ":2:19: material.b: '0' is not allowed, expected the same as in its "
      "transpose" },
    { "covariance",
      "key,mean,material.a,material.b\nmaterial.a,0.03,1,2\n"
      "material.b,0.05,2,1\n",
      ":3:1: the covariances up to this row are not positive definite" },
    { "covariance", "key,mean,material.a\nmaterial.a,x,1\n",
      ":2:12: mean: 'x' is not allowed, expected a number" },
};

static void test_a_wrong_cell_is_one_line_with_its_place(void **state)
{
    (void) state;
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        const char *path = write_own("w.csv", wrong[i].text);
        char text[400];
        const char *const sets[] = { "law.preset=spinodal_gen",
                                     "slope.alpha=0.34", text, NULL };
        struct scene scene;
        struct draws d;
        struct fault why;
        snprintf(text, sizeof text, "ensemble.%s=%s", wrong[i].kind, path);
        scene_set(&scene, sets);
        CHECK(draws_init(&d, &scene, &why) == STATUS_BAD_SCENE, "case %zu", i);
        CHECK(strncmp(why.text, path, strlen(path)) == 0 &&
                  strncmp(why.text + strlen(path), wrong[i].said,
                          strlen(wrong[i].said)) == 0,
              "case %zu: %s", i, why.text);
        draws_free(&d);
        scene_free(&scene);
    }
}

static void test_every_allocation_may_fail(void **state)
{
    const char *path = write_own("f.csv", "id,material.a\n1,0.03\n");
    char text[400];
    const char *const sets[] = { "law.preset=spinodal_gen", "slope.alpha=0.34",
                                 text, NULL };
    enum status s = STATUS_NO_MEMORY;
    struct scene scene;

    (void) state;
    snprintf(text, sizeof text, "ensemble.samples=%s", path);
    scene_set(&scene, sets);
    for (long k = 0; s != STATUS_OK; k++) {
        struct draws d;
        struct fault why;
        fault_alloc_at(k);
        s = draws_init(&d, &scene, &why);
        fault_alloc_at(FAULT_ALLOC_NEVER);
        CHECK(s == STATUS_OK || s == STATUS_NO_MEMORY, "%s", status_text(s));
        draws_free(&d);
    }
    scene_free(&scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_normal_quantiles_are_those_of_the_normal_law),
        cmocka_unit_test(test_scrambled_points_are_nets),
        cmocka_unit_test(test_scramblings_differ_and_have_no_bias),
        cmocka_unit_test(test_moments_are_those_of_the_laws),
        cmocka_unit_test(test_any_block_is_a_part_of_the_whole),
        cmocka_unit_test_setup_teardown(test_a_covariance_is_met,
                                        own_folder_make, own_folder_remove),
        cmocka_unit_test_setup_teardown(test_samples_are_the_rows_of_their_file,
                                        own_folder_make, own_folder_remove),
        cmocka_unit_test_setup_teardown(
            test_a_wrong_cell_is_one_line_with_its_place, own_folder_make,
            own_folder_remove),
        cmocka_unit_test_setup_teardown(test_every_allocation_may_fail,
                                        own_folder_make, own_folder_remove),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
