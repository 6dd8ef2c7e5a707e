/* Limits along asymptotes whose slopes are known. */
#include "limit.h"

#include <math.h>

#include "check.h"

/* x' = 1, y' = slope(x) (1 + y), turned by a quarter where `turned`. */
struct asymptote {
    double (*slope)(double x);
    bool turned;
};

static void field(const void *ctx, struct vec2 z, struct planar_field *f)
{
    const struct asymptote *a = ctx;
    const double along = a->turned ? z.y : z.x, across = a->turned ? z.x : z.y;
    const double slope = a->slope(along) * (1.0 + across);

    f->direction =
        a->turned ? (struct vec2){ slope, 1.0 } : (struct vec2){ 1.0, slope };
    f->log_scale = 0.0;
}

typedef bool asked(const struct planar *sys, int ind, int toward, double dep);

/* Both ways along either coordinate, at a few distances of the other one. */
static bool is_told(double (*slope)(double x), asked *tell, bool is_log)
{
    static const double dep[] = { 0.0, 1e-200, 0.5, 30.0 };
    size_t yes = 0, all = 0;

    for (int turned = 0; turned < 2; turned++)
        for (int toward = -1; toward <= 1; toward += 2)
            for (size_t i = 0; i < sizeof dep / sizeof *dep; i++) {
                const struct asymptote a = { slope, turned == 1 };
                const struct planar sys = {
                    .domain = { { -700.0, -700.0 }, { 700.0, 700.0 } },
                    .origin = { 3.0, -20.0 },
                    .field = field,
                    .ctx = &a,
                    .axis = { { .is_log = is_log }, { .is_log = is_log } },
                };
                yes += tell(&sys, turned, toward, dep[i]);
                all++;
            }
    CHECK(yes == 0 || yes == all, "%zu of %zu are told", yes, all);
    return yes > 0;
}

static bool exists(double (*slope)(double x))
{
    return is_told(slope, limit_exists, false);
}

static double exponential(double x)
{
    return exp(-fabs(x));
}

static double tiny_exponential(double x)
{
    return 1e-20 * exp(-0.5 * fabs(x));
}

static double below_doubles(double x)
{
    return exp(-x * x);
}

static void exponentials_have_limits_however_large(void **state)
{
    (void) state;
    assert_true(exists(exponential));
    assert_true(exists(tiny_exponential));
    assert_true(exists(below_doubles));
}

static double inverse(double x)
{
    return 1e-30 / (1.0 + fabs(x));
}

static double constant(double x)
{
    return x > 0.0 ? 1e-200 : -1e-200;
}

static double mixed(double x)
{
    return exp(-fabs(x)) + 1e-40 / (1.0 + fabs(x));
}

static double growing(double x)
{
    return 1e-300 * exp(0.5 * fabs(x));
}

static void powers_and_constants_have_none_however_small(void **state)
{
    (void) state;
    assert_false(exists(inverse));
    assert_false(exists(constant));
    assert_false(exists(mixed));
    assert_false(exists(growing));
}

static double square(double x)
{
    return 1.0 / (1.0 + x * x);
}

static double late_square(double x)
{
    return 1.0 / (1.0 + fabs(x) + 1e-6 * x * x);
}

static double logarithmic(double x)
{
    const double ln = log(2.0 + fabs(x));
    return 1.0 / ((1.0 + fabs(x)) * ln * ln);
}

static void no_limit_is_told_where_the_integral_diverges_only(void **state)
{
    (void) state;
    for (int is_log = 0; is_log < 2; is_log++) {
        assert_true(is_told(constant, limit_is_none, is_log));
        assert_true(is_told(inverse, limit_is_none, is_log));
        assert_false(is_told(exponential, limit_is_none, is_log));
        assert_false(is_told(square, limit_is_none, is_log));
    }
    assert_false(is_told(late_square, limit_is_none, false));
    assert_false(is_told(logarithmic, limit_is_none, false));
}

static double not_a_number(double x)
{
    return NAN * x;
}

static void nan_is_no_limit(void **state)
{
    (void) state;
    assert_false(exists(not_a_number));
    assert_false(is_told(not_a_number, limit_is_none, false));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(exponentials_have_limits_however_large),
        cmocka_unit_test(powers_and_constants_have_none_however_small),
        cmocka_unit_test(no_limit_is_told_where_the_integral_diverges_only),
        cmocka_unit_test(nan_is_no_limit),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
