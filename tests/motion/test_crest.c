/* The largest value of a function. */
#include "crest.h"

#include <float.h>
#include <math.h>

#include "check.h"

static double hill(const void *ctx, double t)
{
    const double at = *(const double *) ctx;
    return 1.0 - (t - at) * (t - at);
}

static void a_maximum_anywhere_is_found(void **state)
{
    (void) state;
    for (double at = -0.5; at < 1.5; at += 0.0371) {
        const double inside = fmin(fmax(at, 0.0), 1.0);
        double where;
        const double found = crest_of(hill, &at, &where);
        CHECK(fabs(found - hill(&at, inside)) < 1e-8, "at %g: %.12g", at,
              found);
        CHECK(fabs(where - inside) < 2e-5, "at %g: %g", at, where);
    }
}

static double counted(const void *ctx, double t)
{
    ++**(int *const *) ctx;
    return exp(t);
}

static void an_end_that_is_approached_uphill_takes_few_looks(void **state)
{
    int looks = 0, *const count = &looks;
    double where;

    (void) state;
    assert_true(crest_of(counted, &count, &where) == exp(1.0) && where == 1.0);
    CHECK(looks <= 10, "%d", looks);
}

/* Whose last digit is wrong but at the end. */
static double rounded(const void *ctx, double t)
{
    const double at = *(const double *) ctx;
    return 1.0 - 1e-8 * (t - at) * (t - at) - (t < 1.0 ? 2.0 * DBL_EPSILON : 0);
}

static void a_maximum_beside_an_end_is_not_the_end_for_rounding(void **state)
{
    (void) state;
    for (double at = 0.96; at < 1.0; at += 0.007) {
        const double found = crest_of(rounded, &at, NULL);
        CHECK(1.0 - found < 4.0 * DBL_EPSILON, "at %g: 1 - %g", at,
              1.0 - found);
    }
}

static double two_hills(const void *ctx, double t)
{
    (void) ctx;
    return sin(11.0 * t) + 0.1 * t;
}

static void of_two_the_higher_is_found(void **state)
{
    (void) state;
    /* cos(11 t) = -0.1/11, the second time it falls */
    const double t = (2.5 * acos(-1.0) + asin(0.1 / 11.0)) / 11.0;
    CHECK(fabs(crest_of(two_hills, NULL, NULL) - two_hills(NULL, t)) < 1e-8,
          "%g", crest_of(two_hills, NULL, NULL));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_maximum_anywhere_is_found),
        cmocka_unit_test(an_end_that_is_approached_uphill_takes_few_looks),
        cmocka_unit_test(a_maximum_beside_an_end_is_not_the_end_for_rounding),
        cmocka_unit_test(of_two_the_higher_is_found),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
