/* Friction against slip, (25), from smoothed release distances. */
#include "slip_curve.h"

#include <string.h>

#include "experiment.h"
#include "fault_alloc.h"

/* A block whose friction falls like mu_k + (mu_s - mu_k) exp(-s/d): the
 * integral (24) and its inverse are known. */
static const double K = 0.016, mu_k = 0.05, mu_s = 0.6, d = 1e-5;

static double slip_of(double mu)
{
    return -d * log((mu - mu_k) / (mu_s - mu_k));
}

/* K l tan alpha = d (mu_s - mu_k) (1 - e^-u) - s (t - mu_k) with u = s/d */
static double release(double t)
{
    const double s = slip_of(t);

    return (d * (mu_s - mu_k) * -expm1(-s / d) - s * (t - mu_k)) / (K * t);
}

static double parabola(double t)
{
    return 4e-3 * (0.62 - t) * (0.3787 - t) / t;
}

static double parabola_slip(double t)
{
    return 0.016 * 4e-3 * (0.62 + 0.3787 - 2.0 * t);
}

static struct slip_curve fit(const struct measured *m, double smoothing)
{
    struct slip_curve c;

    assert_int_equal(slip_curve_fit(m, K, smoothing, &c), STATUS_OK);
    return c;
}

static void a_parabola_is_kept_at_any_smoothing(void **state)
{
    static const double smoothing[] = { 0.0, 1e-8, 1e-4, 1.0 };
    uint64_t rng = check_seed();
    const struct experiment e =
        experiment_make(parabola, 0.1, 0.36, 12, 0.0, &rng);

    (void) state;
    for (int i = 0; i < 4; i++) {
        const struct measured blind = experiment_blind(&e);
        struct slip_curve c = fit(&blind, smoothing[i]);
        for (size_t k = 0; k < c.count; k++)
            CHECK(fabs(c.at[k].s_k.value / parabola_slip(c.at[k].mu) - 1.0) <
                      1e-5,
                  "smoothing %g: s(%g) = %g", smoothing[i], c.at[k].mu,
                  c.at[k].s_k.value);
        assert_true(c.at[0].mu == 0.1 &&
                    fabs(c.at[c.count - 1].mu - 0.36) < 1e-15);
        slip_curve_free(&c);
        slip_curve_free(&c);
    }
}

static void another_curve_is_followed_where_data_are_good(void **state)
{
    uint64_t rng = check_seed();
    const struct experiment e =
        experiment_make(release, 0.1, 0.5, 40, 0.001, &rng);
    const struct measured m = experiment_known(&e);
    struct slip_curve c = fit(&m, 0.0);
    double worst = 0.0;

    (void) state;
    for (size_t k = 0; k < c.count; k++)
        worst = fmax(worst, fabs(c.at[k].s_k.value / slip_of(c.at[k].mu) - 1));
    CHECK(worst < 0.06 && c.freedom > 3.5, "%g, %g parameters", worst,
          c.freedom);
    slip_curve_free(&c);
    c = fit(&m, 1.0);
    CHECK(c.freedom < 3.1 && c.smoothing == 1.0, "%g", c.freedom);
    slip_curve_free(&c);
}

/* Over all points of many curves, and over the worst quarter of them. */
static void check_coverage(size_t count, bool known)
{
    enum { N = 200 };
    uint64_t rng = check_seed();
    double hits[4] = { 0 }, points = 0, all = 0;

    for (int i = 0; i < N; i++) {
        const struct experiment e =
            experiment_make(release, 0.1, 0.5, count, 0.01, &rng);
        const struct measured m =
            known ? experiment_known(&e) : experiment_blind(&e);
        struct slip_curve c = fit(&m, 0.0);
        for (size_t k = 0; k < c.count; k++) {
            const struct quantity s = c.at[k].s_k;
            hits[4 * k / c.count] +=
                fabs(s.value - slip_of(c.at[k].mu)) <= s.error;
        }
        points += (double) c.count;
        slip_curve_free(&c);
    }
    for (int k = 0; k < 4; k++) {
        CHECK(hits[k] > 0.8 * points / 4, "quarter %d: %.1f %%", k,
              400.0 * hits[k] / points);
        all += hits[k];
    }
    CHECK(all > 0.9 * points && all < 0.99 * points, "%.1f %%",
          100.0 * all / points);
}

static void bands_hold_the_truth_about_as_often_as_they_say(void **state)
{
    (void) state;
    check_coverage(12, false);
    check_coverage(12, true);
    check_coverage(30, false);
    check_coverage(30, true);
}

static void what_is_not_known_has_a_reason(void **state)
{
    uint64_t rng = check_seed();
    const struct experiment e =
        experiment_make(parabola, 0.1, 0.36, 12, 0.01, &rng);
    struct measured m = experiment_known(&e);
    struct slip_curve c;

    (void) state;
    assert_int_equal(slip_curve_fit(&m, 0.0, 0.0, &c), STATUS_OK);
    assert_true(c.count > 0 && c.at[0].gradient > 0.0 &&
                !quantity_exists(&c.at[0].s_k));
    slip_curve_free(&c);
    m.count = 3;
    c = fit(&m, 0.0);
    assert_true(c.count == 0 && c.at == NULL && strstr(c.reason, "too few"));
}

static void no_memory_leaves_an_empty_curve(void **state)
{
    uint64_t rng = check_seed();
    const struct experiment e =
        experiment_make(parabola, 0.1, 0.36, 12, 0.01, &rng);
    const struct measured m = experiment_known(&e);
    struct slip_curve c;

    (void) state;
    fault_alloc_at(0);
    assert_int_equal(slip_curve_fit(&m, K, 0.0, &c), STATUS_NO_MEMORY);
    fault_alloc_at(FAULT_ALLOC_NEVER);
    assert_true(c.at == NULL && c.count == 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_parabola_is_kept_at_any_smoothing),
        cmocka_unit_test(another_curve_is_followed_where_data_are_good),
        cmocka_unit_test(bands_hold_the_truth_about_as_often_as_they_say),
        cmocka_unit_test(what_is_not_known_has_a_reason),
        cmocka_unit_test(no_memory_leaves_an_empty_curve),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
