/* Fits of (30): memory length and friction from persistence lengths. */
#include "persistence.h"

#include <string.h>

#include "experiment.h"

static const double L = 0.9e-6, mu_star = 0.369, eta = 100.0 / 101.0,
                    weakening = 0.014;

/* -eta L ln tanh(psi_sp/2), as printed. */
static double length(double t)
{
    return -eta * L * log(tanh(0.5 * exp(-(mu_star - t) / weakening)));
}

static struct persistence fit(const struct measured *m)
{
    struct persistence p;

    assert_int_equal(persistence_fit(m, eta, weakening, &p), STATUS_OK);
    return p;
}

static void exact_data_give_the_exact_numbers(void **state)
{
    uint64_t rng = check_seed();
    const struct experiment e =
        experiment_make(length, 0.1, 0.39, 12, 0.0, &rng);
    const struct measured m = experiment_blind(&e);
    const struct persistence p = fit(&m);

    (void) state;
    CHECK(fabs(p.L.value / L - 1.0) < 1e-10 &&
              fabs(p.mu_star.value - mu_star) < 1e-11,
          "%.17g %.17g", p.L.value, p.mu_star.value);
}

static void check_coverage(bool known)
{
    enum { N = 2000 };
    uint64_t rng = check_seed();
    int hits[2] = { 0 };

    for (int i = 0; i < N; i++) {
        const struct experiment e =
            experiment_make(length, 0.1, 0.39, 12, 0.01, &rng);
        const struct measured m =
            known ? experiment_known(&e) : experiment_blind(&e);
        const struct persistence p = fit(&m);
        hits[0] += p.L_low <= L && L <= p.L_high;
        hits[1] += p.mu_star_low <= mu_star && mu_star <= p.mu_star_high;
        assert_true(fabs(p.L_low + p.L.error - p.L.value) < 1e-15);
    }
    for (int k = 0; k < 2; k++)
        CHECK(hits[k] > 0.935 * N && hits[k] < 0.965 * N, "%d: %d of %d", k,
              hits[k], N);
}

static void intervals_hold_the_truth_as_often_as_they_say(void **state)
{
    (void) state;
    check_coverage(true);
    check_coverage(false);
}

/* exp(-psi) underflows, and psi itself, far from what may be measured. */
static void weak_and_strong_weakening_are_fitted(void **state)
{
    static const double strong[] = { 1e-6, 1e-3, 0.3 };

    (void) state;
    for (int i = 0; i < 3; i++) {
        const double d = strong[i];
        double x[6], value[6];
        struct persistence p;
        for (int k = 0; k < 6; k++) {
            x[k] = 0.1 + 0.04 * k;
            value[k] = L * (log(2.0) + (0.4 - x[k]) / d);
            if (d > 0.01)
                value[k] = -L * log(tanh(0.5 * exp(-(0.4 - x[k]) / d)));
        }
        const struct measured m = { x, value, NULL, 6 };
        assert_int_equal(persistence_fit(&m, 1.0, d, &p), STATUS_OK);
        CHECK(fabs(p.L.value / L - 1.0) < 1e-6 &&
                  fabs(p.mu_star.value - 0.4) < 1e-6,
              "b - a = %g: %g %g", d, p.L.value, p.mu_star.value);
    }
}

static void what_cannot_be_fitted_has_a_reason(void **state)
{
    const double x[] = { 0.1, 0.2, 0.3 }, up[] = { 1.0, 2.0, 3.0 };
    const double down[] = { 3.0, 2.0, 1.0 };
    struct measured m = { x, up, NULL, 3 };
    struct persistence p = fit(&m);

    (void) state;
    assert_non_null(strstr(p.L.reason, "does not fall"));
    m.value = down;
    p = fit(&m);
    assert_true(quantity_exists(&p.L) && p.points == 3);
    m.count = 2;
    p = fit(&m);
    assert_non_null(strstr(p.L.reason, "too few"));
    m.count = 3;
    assert_int_equal(persistence_fit(&m, eta, -0.01, &p), STATUS_OK);
    assert_non_null(strstr(p.mu_star.reason, "b > a"));
}

static void errors_too_small_are_told(void **state)
{
    uint64_t rng = check_seed();
    struct experiment e = experiment_make(length, 0.1, 0.39, 12, 0.02, &rng);
    const struct measured m = experiment_known(&e);

    (void) state;
    assert_null(fit(&m).warning);
    for (size_t i = 0; i < e.count; i++)
        e.error[i] *= 0.2;
    assert_non_null(fit(&m).warning);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(exact_data_give_the_exact_numbers),
        cmocka_unit_test(intervals_hold_the_truth_as_often_as_they_say),
        cmocka_unit_test(weak_and_strong_weakening_are_fitted),
        cmocka_unit_test(what_cannot_be_fitted_has_a_reason),
        cmocka_unit_test(errors_too_small_are_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
