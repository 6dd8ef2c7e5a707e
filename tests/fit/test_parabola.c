/* Fits of (33): intervals that hold the truth as often as they say, and what
 * is said where the data say too little.
 *
 * FIT_SETS=20000 fits more data sets than a test can afford. */
#include "parabola.h"

#include <string.h>

#include "experiment.h"

enum { TRUE_VALUES = 3 };
static const double mu_s = 0.62, mu_half = 0.3787, factor = 3.95e-3;

static double release(double t)
{
    return factor * (mu_s - t) * (mu_half - t) / t;
}

static struct parabola fit(const struct measured *m)
{
    struct parabola p;

    assert_int_equal(parabola_fit(m, &p), STATUS_OK);
    return p;
}

static int sets(int usual)
{
    const char *more = getenv("FIT_SETS");

    return more ? atoi(more) : usual;
}

/* ---- intervals ----------------------------------------------------------- */

static void count_hits(const struct parabola *p, int hits[TRUE_VALUES])
{
    hits[0] += p->mu_s_low <= mu_s && mu_s <= p->mu_s_high;
    hits[1] += p->mu_half_low <= mu_half && mu_half <= p->mu_half_high;
    hits[2] += p->factor_low <= factor && factor <= p->factor_high;
}

/* Of n data sets lo to hi per cent of the intervals must hold the truth. */
static void check_coverage(int n, double noise, bool known, double lo,
                           double hi)
{
    int hits[TRUE_VALUES] = { 0 };
    uint64_t rng = check_seed();

    for (int i = 0; i < n; i++) {
        const struct experiment e =
            experiment_make(release, 0.1, 0.36, 12, noise, &rng);
        const struct measured m =
            known ? experiment_known(&e) : experiment_blind(&e);
        const struct parabola p = fit(&m);
        count_hits(&p, hits);
    }
    print_message("# %d sets, noise %g, errors %s: %.1f %% of mu_s, %.1f %% of "
                  "mu_half, %.1f %% of factor\n",
                  n, noise, known ? "given" : "unknown", 100.0 * hits[0] / n,
                  100.0 * hits[1] / n, 100.0 * hits[2] / n);
    for (int k = 0; k < TRUE_VALUES; k++)
        CHECK(100 * hits[k] >= lo * n && 100 * hits[k] <= hi * n,
              "number %d: %d of %d intervals hold the truth", k, hits[k], n);
}

static void of_200_sets_90_to_99_per_cent_hold_the_truth(void **state)
{
    (void) state;
    check_coverage(200, 0.01, true, 90.0, 99.0);
    check_coverage(200, 0.01, false, 90.0, 99.0);
}

static void intervals_hold_the_truth_as_often_as_they_say(void **state)
{
    (void) state;
    check_coverage(sets(4000), 0.01, true, 93.6, 96.4);
    check_coverage(sets(4000), 0.01, false, 93.6, 96.4);
}

static void so_do_those_of_poor_data(void **state)
{
    (void) state;
    check_coverage(sets(4000), 0.05, true, 93.6, 96.4);
    check_coverage(sets(4000), 0.05, false, 93.3, 96.7);
}

static void standard_deviations_are_those_of_many_fits(void **state)
{
    enum { N = 4000 };
    double sum[3] = { 0 }, square[3] = { 0 }, cross = 0, covariance = 0;
    double deviation[3] = { 0 };
    uint64_t rng = check_seed();

    (void) state;
    for (int i = 0; i < N; i++) {
        const struct experiment e =
            experiment_make(release, 0.1, 0.36, 12, 0.01, &rng);
        const struct measured m = experiment_known(&e);
        const struct parabola p = fit(&m);
        const double d[] = { p.mu_s.value - mu_s, p.mu_half.value - mu_half,
                             p.factor.value - factor };
        const double of[] = { p.mu_s_deviation, p.mu_half_deviation,
                              p.factor_deviation };
        for (int k = 0; k < 3; k++) {
            sum[k] += d[k];
            square[k] += d[k] * d[k];
            deviation[k] += of[k] / N;
        }
        cross += d[0] * d[1];
        covariance += p.mu_s_mu_half / N;
    }
    for (int k = 0; k < 3; k++) {
        const double found = sqrt(square[k] / N);
        CHECK(fabs(found / deviation[k] - 1.0) < 0.06 &&
                  fabs(sum[k] / N) < 0.1 * found,
              "number %d: %g, told %g, bias %g", k, found, deviation[k],
              sum[k] / N);
    }
    CHECK(fabs(cross / N / covariance - 1.0) < 0.1, "%g, told %g", cross / N,
          covariance);
}

/* ---- exact data ---------------------------------------------------------- */

static void exact_data_give_the_exact_parabola(void **state)
{
    uint64_t rng = check_seed();
    const struct experiment e =
        experiment_make(release, 0.1, 0.36, 12, 0.0, &rng);
    const struct measured m = experiment_blind(&e);
    const struct parabola p = fit(&m);

    (void) state;
    CHECK(fabs(p.mu_s.value - mu_s) < 1e-9 &&
              fabs(p.mu_half.value - mu_half) < 1e-11 &&
              fabs(p.factor.value / factor - 1.0) < 1e-9,
          "%.17g %.17g %.17g", p.mu_s.value, p.mu_half.value, p.factor.value);
    CHECK(p.mu_s.error < 1e-9 && p.scatter < 1e-9 && !p.warning &&
              p.points == 12 && p.freedom == 9,
          "%g %g %s", p.mu_s.error, p.scatter, p.warning ? p.warning : "");
}

static void the_scatter_is_that_of_the_noise(void **state)
{
    uint64_t rng = check_seed();
    const struct experiment e =
        experiment_make(release, 0.1, 0.36, EXPERIMENT_MAX, 0.03, &rng);
    const struct measured blind = experiment_blind(&e);
    const struct measured known = experiment_known(&e);
    const struct parabola p = fit(&blind), q = fit(&known);

    (void) state;
    CHECK(fabs(p.scatter / 0.03 - 1.0) < 0.3, "%g", p.scatter);
    CHECK(q.chi2 > 30.0 && q.chi2 < 100.0 && q.chance > 0.001 && !q.warning,
          "%g %g", q.chi2, q.chance);
    assert_true(isnan(p.chance) && isnan(q.scatter));
}

/* The order of the points, and points at one slope, make no difference. */
static void any_order_and_repeated_slopes_will_do(void **state)
{
    uint64_t rng = check_seed();
    const struct experiment e =
        experiment_make(release, 0.1, 0.36, 12, 0.01, &rng);
    struct experiment mixed = { .count = 24 };

    (void) state;
    for (size_t i = 0; i < 24; i++) {
        const size_t from = (7 * i + 3) % 12;
        mixed.x[i] = e.x[from];
        mixed.value[i] = e.value[from];
        mixed.error[i] = e.error[from] * sqrt(2.0);
    }
    const struct measured a = experiment_known(&e);
    const struct measured b = experiment_known(&mixed);
    const struct parabola p = fit(&a), q = fit(&b);
    CHECK(fabs(p.mu_s.value - q.mu_s.value) < 1e-9 &&
              fabs(p.mu_s_deviation / q.mu_s_deviation - 1.0) < 1e-6 &&
              fabs(p.mu_s_high - q.mu_s_high) < 1e-8,
          "%.17g %.17g", p.mu_s.value, q.mu_s.value);
}

/* ---- what the data cannot tell ------------------------------------------- */

static double near_release(double t)
{
    return factor * (0.385 - t) * (0.38 - t) / t;
}

static void roots_too_near_each_other_are_told(void **state)
{
    int together = 0, none = 0;
    uint64_t rng = check_seed();

    (void) state;
    for (int i = 0; i < 200; i++) {
        const struct experiment e =
            experiment_make(near_release, 0.1, 0.36, 12, 0.05, &rng);
        const struct measured m = experiment_known(&e);
        const struct parabola p = fit(&m);
        together += p.warning && strstr(p.warning, "apart");
        if (quantity_exists(&p.mu_s))
            continue;
        none++;
        assert_true(isnan(p.mu_s_low) && isnan(p.mu_s_mu_half));
        CHECK(fabs(p.mu_middle.value - 0.3825) < 3 * p.mu_middle.error,
              "%g +- %g", p.mu_middle.value, p.mu_middle.error);
    }
    /* some 2.5 % look apart by chance */
    CHECK(together > 185 && none > 40 && none < 160, "%d %d", together, none);
}

static double straight_release(double t)
{
    return 1e-3 * (0.38 - t) / t;
}

static void a_line_has_no_larger_root(void **state)
{
    int open = 0;
    uint64_t rng = check_seed();

    (void) state;
    for (int i = 0; i < 100; i++) {
        const struct experiment e =
            experiment_make(straight_release, 0.1, 0.36, 12, 0.02, &rng);
        const struct measured m = experiment_known(&e);
        const struct parabola p = fit(&m);
        assert_non_null(p.warning);
        if (!quantity_exists(&p.factor))
            assert_non_null(strstr(p.factor.reason, "bend"));
        else if (isinf(p.mu_s_high))
            open +=
                strstr(p.warning, "upper bound") || strstr(p.warning, "apart");
    }
    CHECK(open > 30 && open < 70, "%d", open);
}

static void too_few_slopes_are_a_reason(void **state)
{
    uint64_t rng = check_seed();
    struct experiment e = experiment_make(release, 0.1, 0.3, 3, 0.01, &rng);
    struct measured m = experiment_blind(&e);
    struct parabola p = fit(&m);

    (void) state;
    assert_true(p.warning && strstr(p.mu_s.reason, "too few"));
    m.error = e.error;
    p = fit(&m);
    CHECK(quantity_exists(&p.mu_s) && p.freedom == 0 && p.chance == 1.0, "%g",
          p.chance);
    e.x[2] = e.x[1];
    p = fit(&m);
    assert_non_null(strstr(p.factor.reason, "too few"));
}

static void errors_too_small_are_told(void **state)
{
    uint64_t rng = check_seed();
    struct experiment e = experiment_make(release, 0.1, 0.36, 12, 0.02, &rng);
    const struct measured m = experiment_known(&e);

    (void) state;
    for (size_t i = 0; i < e.count; i++)
        e.error[i] *= 0.2;
    const struct parabola p = fit(&m);
    CHECK(p.warning && strstr(p.warning, "scatter more"), "%g", p.chance);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(of_200_sets_90_to_99_per_cent_hold_the_truth),
        cmocka_unit_test(intervals_hold_the_truth_as_often_as_they_say),
        cmocka_unit_test(so_do_those_of_poor_data),
        cmocka_unit_test(standard_deviations_are_those_of_many_fits),
        cmocka_unit_test(exact_data_give_the_exact_parabola),
        cmocka_unit_test(the_scatter_is_that_of_the_noise),
        cmocka_unit_test(any_order_and_repeated_slopes_will_do),
        cmocka_unit_test(roots_too_near_each_other_are_told),
        cmocka_unit_test(a_line_has_no_larger_root),
        cmocka_unit_test(too_few_slopes_are_a_reason),
        cmocka_unit_test(errors_too_small_are_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
