#include "newton.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "check.h"

/* x^3 + x = a, with the calls counted and the bracket guarded. */
struct cubic {
    double a, lo, hi;
    size_t *strays;
};

static double cubic(const void *ctx, double x)
{
    const struct cubic *c = ctx;

    if (!(x >= c->lo && x <= c->hi))
        ++*c->strays;
    return x * (x * x + 1.0) - c->a;
}

static void root_is_found_down_to_adjacent_numbers(void **state)
{
    uint64_t rng = check_seed();
    size_t strays = 0, calls = 0;

    (void) state;
    for (int i = 0; i < 2000; i++) {
        const double true_x = check_uniform(&rng, -3.0, 3.0);
        const struct cubic c = { true_x * (true_x * true_x + 1.0),
                                 true_x - check_uniform(&rng, 0.0, 5.0),
                                 true_x + check_uniform(&rng, 0.0, 5.0),
                                 &strays };
        struct newton_root r;
        const enum status s = newton_find(cubic, &c, c.lo, c.hi, 0.0, &r);
        CHECK(s == STATUS_OK, "%s", status_text(s));
        const double ulp = fabs(nextafter(r.x, INFINITY) - r.x);
        CHECK(r.error <= 2.0 * ulp, "x = %a, error = %a", r.x, r.error);
        CHECK(fabs(r.x - true_x) <= r.error + 4.0 * DBL_EPSILON * fabs(true_x),
              "x = %a, true %a, error %a", r.x, true_x, r.error);
        calls += r.calls;
    }
    CHECK(strays == 0, "%zu calls outside the bracket", strays);
    CHECK(calls < 2000 * 16, "%g calls a root", (double) calls / 2000.0);
}

static long double root_two(const void *ctx, long double x)
{
    (void) ctx;
    return x * x - 2.0L;
}

static void long_double_uses_all_its_digits(void **state)
{
    volatile long double one = 1.0L;
    struct newton_root_long r;

    (void) state;
    assert_int_equal(newton_find_long(root_two, NULL, 0.0L, 2.0L, 0.0L, &r),
                     STATUS_OK);
    if (one + LDBL_EPSILON == one) /* emulated with fewer digits */
        return;
    CHECK(fabsl(r.x - sqrtl(2.0L)) <= LDBL_EPSILON, "off by %Lg",
          r.x - sqrtl(2.0L));
    CHECK(r.error <= 2.0L * LDBL_EPSILON, "error %Lg", r.error);
}

static double line(const void *ctx, double x)
{
    return x - *(const double *) ctx;
}

static void tolerance_bounds_the_error_that_is_returned(void **state)
{
    uint64_t rng = check_seed();

    (void) state;
    for (int i = 0; i < 1000; i++) {
        const double root = check_uniform(&rng, -1.0, 1.0);
        const double a = tan(root); /* x = root solves tan x = a */
        const double tol = exp(check_uniform(&rng, -30.0, -1.0));
        struct newton_root r;
        assert_int_equal(newton_find(line, &a, -10.0, 10.0, tol, &r),
                         STATUS_OK);
        CHECK(r.error <= tol, "error %g > tol %g", r.error, tol);
        CHECK(fabs(r.x - a) <= r.error, "x - a = %g, error %g", r.x - a,
              r.error);
    }
}

static double jump(const void *ctx, double x)
{
    return x < *(const double *) ctx ? -1.0 : 1e-300;
}

static double flat(const void *ctx, double x)
{
    return pow(x - *(const double *) ctx, 9.0);
}

static double cliff(const void *ctx, double x)
{
    return sinh(1e4 * (x - *(const double *) ctx)); /* +-infinity */
}

static void nasty_functions_cost_at_most_four_bisections(void **state)
{
    double (*const f[])(const void *, double) = { jump, flat, cliff };
    uint64_t rng = check_seed();

    (void) state;
    for (size_t i = 0; i < 600; i++) {
        const double a = check_uniform(&rng, 0.1, 1.0);
        struct newton_root r;
        const enum status s = newton_find(f[i % 3], &a, -2.0, 3.0, 0.0, &r);
        CHECK(s == STATUS_OK, "%zu: %s", i % 3, status_text(s));
        CHECK(r.calls <= 2 + 4 * 60, "%zu: %zu calls", i % 3, r.calls);
        /* (x - a)^9 underflows to zero within 1e-36, far below an ulp. */
        CHECK(fabs(r.x - a) <= DBL_EPSILON, "%zu: off by %g", i % 3, r.x - a);
    }
}

static void root_at_an_end_is_exact(void **state)
{
    const double a = 0.25;
    struct newton_root r;

    (void) state;
    assert_int_equal(newton_find(line, &a, 0.25, 1.0, 0.0, &r), STATUS_OK);
    CHECK(r.x == 0.25 && r.error == 0.0, "%g +- %g", r.x, r.error);
    assert_int_equal(newton_find(line, &a, -1.0, 0.25, 0.0, &r), STATUS_OK);
    CHECK(r.x == 0.25 && r.error == 0.0, "%g +- %g", r.x, r.error);
}

static double no_number(const void *ctx, double x)
{
    const double a = *(const double *) ctx;
    return fabs(x - a) < 0.1 ? (double) NAN : x - a;
}

static void failures_leave_the_output_untouched(void **state)
{
    const double a = 0.25;
    struct newton_root r, before;

    (void) state;
    memset(&r, 0x5a, sizeof r);
    before = r;
    assert_int_equal(newton_find(line, &a, 1.0, 2.0, 0.0, &r),
                     STATUS_BAD_ARGUMENT);
    assert_int_equal(newton_find(line, &a, 2.0, -2.0, 0.0, &r),
                     STATUS_BAD_ARGUMENT);
    assert_int_equal(newton_find(line, &a, NAN, 2.0, 0.0, &r),
                     STATUS_BAD_ARGUMENT);
    assert_int_equal(newton_find(no_number, &a, -1.0, 2.0, 0.0, &r),
                     STATUS_NO_CONVERGENCE);
    assert_memory_equal(&r, &before, sizeof r);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(root_is_found_down_to_adjacent_numbers),
        cmocka_unit_test(long_double_uses_all_its_digits),
        cmocka_unit_test(tolerance_bounds_the_error_that_is_returned),
        cmocka_unit_test(nasty_functions_cost_at_most_four_bisections),
        cmocka_unit_test(root_at_an_end_is_exact),
        cmocka_unit_test(failures_leave_the_output_untouched),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
