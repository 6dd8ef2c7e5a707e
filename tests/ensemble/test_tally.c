/* Means and their errors: closed forms, and how often the errors hold. */
#include "tally.h"

#include <math.h>

#include "check.h"
#include "normal.h"

enum { RUNS = 200, DRAWS = 16384, DIMENSIONS = 3 };

/* E exp(sum of z/2) = exp(3/8). */
static double smooth(const double u[DIMENSIONS])
{
    double sum = 0.0;

    for (int d = 0; d < DIMENSIONS; d++)
        sum += normal_quantile(u[d]);
    return exp(0.5 * sum);
}
static const double smooth_mean = 1.4549914146182013;

/* P(u0 + u1 < 0.7) = 0.245. */
static double step(const double u[DIMENSIONS])
{
    return u[0] + u[1] < 0.7 ? 1.0 : 0.0;
}

struct counted {
    size_t held;
    double square; /* mean of the true errors' squares */
};

static struct counted repeat(enum ensemble_method method,
                             double (*of)(const double u[DIMENSIONS]),
                             double truth, bool share)
{
    const struct draws d = { .method = method };
    struct counted c = { 0, 0.0 };
    struct sobol s;

    assert_int_equal(sobol_init(&s, DIMENSIONS, DRAWS / ENSEMBLE_REPEATS),
                     STATUS_OK);
    for (uint64_t run = 0; run < RUNS; run++) {
        const uint64_t seed = sobol_hash(check_seed(), run);
        struct tally t = { .part = { { 0.0, 0.0, 0.0 } } };
        for (size_t i = 0; i < DRAWS; i++) {
            const size_t each = DRAWS / ENSEMBLE_REPEATS, r = i / each;
            double u[DIMENSIONS];
            for (size_t k = 0; k < DIMENSIONS; k++)
                u[k] = method == ENSEMBLE_SOBOL
                           ? sobol_at(&s, i % each, k, sobol_hash(seed, r))
                           : sobol_unit(sobol_hash(sobol_hash(seed, i), k));
            tally_add(&t, r, of(u));
        }
        const struct estimate e =
            share ? tally_share(&t, &d) : tally_mean(&t, &d);
        c.held += fabs(e.value - truth) <= e.error;
        c.square += (e.value - truth) * (e.value - truth) / RUNS;
    }
    return c;
}

/* Of 200 at 0.95: 190 +- 3.1. */
static void check_held(const char *what, const struct counted *c)
{
    CHECK(c->held >= 179 && c->held <= 199, "%s: %zu of %d hold", what, c->held,
          RUNS);
}

static void test_errors_hold_in_95_of_100(void **state)
{
    struct counted c[4];

    (void) state;
    c[0] = repeat(ENSEMBLE_SOBOL, smooth, smooth_mean, false);
    c[1] = repeat(ENSEMBLE_SOBOL, step, 0.245, true);
    c[2] = repeat(ENSEMBLE_RANDOM, smooth, smooth_mean, false);
    c[3] = repeat(ENSEMBLE_RANDOM, step, 0.245, true);
    check_held("sobol, smooth", &c[0]);
    check_held("sobol, step", &c[1]);
    check_held("random, smooth", &c[2]);
    check_held("random, step", &c[3]);
    CHECK(sqrt(c[2].square / c[0].square) >= 10.0,
          "a smooth mean of scrambled points is only %.3g times as good",
          sqrt(c[2].square / c[0].square));
    CHECK(sqrt(c[3].square / c[1].square) >= 2.0,
          "a share of scrambled points is only %.3g times as good",
          sqrt(c[3].square / c[1].square));
    print_message("# sobol against random: smooth %.1f, step %.1f times\n",
                  sqrt(c[2].square / c[0].square),
                  sqrt(c[3].square / c[1].square));
}

static void test_means_and_variances_are_those_of_all(void **state)
{
    struct tally t = { .part = { { 0.0, 0.0, 0.0 } } };
    const struct draws d = { .method = ENSEMBLE_RANDOM };
    double sum = 0.0, squares = 0.0;
    uint64_t rng = check_seed();

    (void) state;
    for (int i = 0; i < 1000; i++) {
        const double x = 1e6 + check_uniform(&rng, 0.0, 1.0);
        tally_add(&t, (size_t) i % 3, x);
        sum += x - 1e6;
        squares += (x - 1e6) * (x - 1e6);
    }
    const double variance = (squares - sum * sum / 1000.0) / 999.0;
    const struct estimate e = tally_mean(&t, &d);
    CHECK(fabs(e.value - 1e6 - sum / 1000.0) < 1e-9, "%.17g", e.value);
    CHECK(fabs(tally_variance(&t) / variance - 1.0) < 1e-8, "%.17g against %g",
          tally_variance(&t), variance);
    CHECK(fabs(e.error - 1.9599639845400543 * sqrt(variance / 1000.0)) < 1e-9,
          "%g", e.error);
}

static void test_what_never_happened_may_happen(void **state)
{
    struct tally t = { .part = { { 0.0, 0.0, 0.0 } } };
    const struct draws d = { .method = ENSEMBLE_SOBOL };

    (void) state;
    for (size_t i = 0; i < 800; i++)
        tally_add(&t, i % ENSEMBLE_REPEATS, 0.0);
    const struct estimate e = tally_share(&t, &d);
    assert_true(e.value == 0.0);
    /* (1 - p)^800 = 0.025 */
    CHECK(fabs(pow(1.0 - e.error, 800) - 0.025) < 1e-3, "%g", e.error);
}

static void test_a_grid_has_no_error_and_nothing_no_mean(void **state)
{
    struct tally t = { .part = { { 0.0, 0.0, 0.0 } } };
    const struct draws d = { .method = ENSEMBLE_GRID };

    (void) state;
    assert_true(isnan(tally_mean(&t, &d).value));
    tally_add(&t, 0, 2.0);
    assert_true(tally_mean(&t, &d).value == 2.0 &&
                isnan(tally_mean(&t, &d).error));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_errors_hold_in_95_of_100),
        cmocka_unit_test(test_means_and_variances_are_those_of_all),
        cmocka_unit_test(test_what_never_happened_may_happen),
        cmocka_unit_test(test_a_grid_has_no_error_and_nothing_no_mean),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
