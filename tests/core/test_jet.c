#include "jet_operations.h"

#include <float.h>
#include <math.h>

#include "check.h"

/* Series of exp(a s), of exp(-a s/2) in the other lane. */
static void exponential(double a, jet_pair u[])
{
    const jet_pair both = { a, -0.5 * a };

    u[0] = JET_PAIR(1.0);
    for (size_t k = 1; k < JET_SIZE; k++)
        u[k] = u[k - 1] * both / (double) k;
}

static void check_series(const jet_pair u[], const jet_pair ref[], double ulps,
                         const char *what)
{
    for (size_t k = 0; k < JET_SIZE; k++)
        for (int i = 0; i < JET_LANES; i++)
            CHECK(fabs(u[k][i] - ref[k][i]) <=
                      ulps * DBL_EPSILON * fabs(ref[k][i]),
                  "%s, lane %d: coefficient %zu is %a, true %a", what, i, k,
                  u[k][i], ref[k][i]);
}

static void product_of_exponentials_adds_their_rates(void **state)
{
    jet_pair u[JET_SIZE], v[JET_SIZE], ref[JET_SIZE], w[JET_SIZE];

    (void) state;
    exponential(0.75, u);
    exponential(0.5, v);
    exponential(1.25, ref);
    for (size_t k = 0; k < JET_SIZE; k++)
        w[k] = jet_product(k, u, v);
    check_series(w, ref, 64.0, "exp(0.75 s) exp(0.5 s)");
}

static void quotient_undoes_the_product(void **state)
{
    jet_pair one[JET_SIZE] = { { 1.0, 3.0 } };
    jet_pair den[JET_SIZE] = { { 1.0, 1.0 }, { -0.5, 0.25 } };
    jet_pair q[JET_SIZE], ref[JET_SIZE];

    (void) state;
    for (size_t k = 0; k < JET_SIZE; k++) {
        q[k] = jet_quotient(k, one, den, q);
        ref[k][0] = ldexp(1.0, -(int) k);
        ref[k][1] = ldexp(k % 2 ? -3.0 : 3.0, -2 * (int) k);
    }
    check_series(q, ref, 0.0, "1/(1 - s/2), 3/(1 + s/4)");

    uint64_t rng = check_seed();
    jet_pair num[JET_SIZE], back[JET_SIZE];
    for (size_t k = 0; k < JET_SIZE; k++)
        for (int i = 0; i < JET_LANES; i++) {
            num[k][i] = check_uniform(&rng, 1.0, 2.0);
            den[k][i] = k ? check_uniform(&rng, -0.01, 0.01) : 3.0;
        }
    for (size_t k = 0; k < JET_SIZE; k++)
        q[k] = jet_quotient(k, num, den, q);
    for (size_t k = 0; k < JET_SIZE; k++)
        back[k] = jet_product(k, q, den);
    check_series(back, num, 16.0, "(num/den) den");
}

/* e = exp(u): e' = u' e. */
static void chain_gives_the_exponential_of_a_series(void **state)
{
    static struct jet_work w;
    jet_pair u[JET_SIZE] = { 0 }, e[JET_SIZE] = { { 1.0, 1.0 } };
    jet_pair du[JET_SIZE] = { 0 }, ref[JET_SIZE];

    (void) state;
    for (size_t k = 1; k < JET_SIZE; k++) /* -log(1 -+ s): exp u = 1/(1 -+ s) */
        u[k] = (jet_pair){ 1.0, k % 2 ? -1.0 : 1.0 } / (double) k;
    for (size_t k = 1; k < JET_SIZE; k++)
        du[k] = jet_number[k] * u[k];
    for (size_t k = 1; k < JET_SIZE; k++)
        e[k] = jet_chain(&w, k, u, du, e);
    for (size_t k = 0; k < JET_SIZE; k++)
        ref[k] = (jet_pair){ 1.0, k % 2 ? -1.0 : 1.0 };
    check_series(e, ref, 64.0, "exp(-log(1 -+ s))");
}

/* sine and cosine of 3 s, with and without the shortcut for linear series. */
static void chain_gives_sine_and_cosine(void **state)
{
    static struct jet_work w;
    jet_pair u[JET_SIZE] = { { 0.0, 0.0 }, { 3.0, -1.5 } };
    const jet_pair *const du = u; /* 0 and u[1] */

    (void) state;
    for (int pass = 0; pass < 2; pass++) {
        jet_pair s[JET_SIZE] = { 0 }, c[JET_SIZE] = { { 1.0, 1.0 } };
        jet_pair ref[JET_SIZE];
        w.linear = pass ? u : NULL;
        for (size_t k = 1; k < JET_SIZE; k++) {
            s[k] = jet_chain(&w, k, u, du, c);
            c[k] = -jet_chain(&w, k, u, du, s);
        }
        exponential(3.0, ref);
        for (size_t k = 0; k < JET_SIZE; k++)
            ref[k] *= k % 2 ? (k % 4 == 1 ? 1.0 : -1.0) : 0.0;
        check_series(s, ref, 64.0, pass ? "sin, linear" : "sin");
        exponential(3.0, ref);
        for (size_t k = 0; k < JET_SIZE; k++)
            ref[k] *= k % 2 ? 0.0 : (k % 4 == 0 ? 1.0 : -1.0);
        check_series(c, ref, 64.0, pass ? "cos, linear" : "cos");
    }
}

static void series_sum_to_their_function_and_its_slope(void **state)
{
    jet_pair both[JET_SIZE];
    double u[JET_SIZE];
    uint64_t rng = check_seed();

    (void) state;
    exponential(-2.0, both);
    jet_take(JET_SIZE - 1, both, 1, u);
    for (int i = 0; i < 1000; i++) {
        const double s = check_uniform(&rng, -2.0, 2.0);
        CHECK(fabs(jet_at(JET_SIZE - 1, u, s) - exp(s)) < 1e-14, "s = %a", s);
        CHECK(fabs(jet_slope_at(JET_SIZE - 1, u, s) - exp(s)) < 1e-14, "s = %a",
              s);
    }
    CHECK(jet_at(2, u, 2.0) == 5.0, "order 2: %g", jet_at(2, u, 2.0));
    CHECK(jet_slope_at(2, u, 2.0) == 3.0, "order 2");
    CHECK(jet_slope_at(0, u, 2.0) == 0.0, "constant");
}

/* exp(s + t) - exp(s) is largest at t = h, exp(-s - t) - exp(-s) at -h. */
static void spread_is_how_far_a_series_gets(void **state)
{
    jet_pair both[JET_SIZE];
    double u[JET_SIZE];
    uint64_t rng = check_seed();

    (void) state;
    for (int lane = 0; lane < 2; lane++) {
        exponential(lane ? 2.0 : 1.0, both);
        jet_take(JET_SIZE - 1, both, (size_t) lane, u);
        for (int i = 0; i < 1000; i++) {
            const double s = check_uniform(&rng, -1.0, 1.0);
            const double h = check_uniform(&rng, 0.0, 1.0);
            const double got = jet_spread_at(JET_SIZE - 1, u, s, h);
            const double far = exp(lane ? -s : s) * expm1(h);
            const double rounding =
                2 * JET_SIZE * DBL_EPSILON * exp(fabs(s) + h);
            CHECK(fabs(got - far) <= rounding,
                  "lane %d, s = %a, h = %a: %a, "
                  "true %a",
                  lane, s, h, got, far);
        }
    }
    CHECK(jet_spread_at(0, u, 0.5, 1.0) == 0.0, "constant");
    CHECK(jet_spread_at(2, (double[]){ 7, -4, 1 }, 2.0, 0.5) == 0.25,
          "its least value");
}

static void slots_are_found_again_in_call_order(void **state)
{
    static struct jet_work w;
    jet_pair *const first = jet_slot(&w), *const second = jet_slot(&w);

    (void) state;
    assert_true(first != second);
    w.used = 0;
    assert_ptr_equal(jet_slot(&w), first);
    assert_ptr_equal(jet_slot(&w), second);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(product_of_exponentials_adds_their_rates),
        cmocka_unit_test(quotient_undoes_the_product),
        cmocka_unit_test(chain_gives_the_exponential_of_a_series),
        cmocka_unit_test(chain_gives_sine_and_cosine),
        cmocka_unit_test(series_sum_to_their_function_and_its_slope),
        cmocka_unit_test(spread_is_how_far_a_series_gets),
        cmocka_unit_test(slots_are_found_again_in_call_order),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
