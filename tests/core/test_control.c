#include "control.h"

#include <math.h>

#include "check.h"
#include "tolerance.h"

static void errors_above_one_and_nan_are_rejected(void **state)
{
    const double bad[] = { 1.0 + 1e-15, 1e300, INFINITY, NAN };

    (void) state;
    for (size_t i = 0; i < 4; i++) {
        struct control c = CONTROL_INIT(5.0);
        double factor = 0.0;
        assert_false(control_judge(&c, bad[i], &factor));
        CHECK(factor >= TOL_STEP_SHRINK && factor < 1.0, "factor %g", factor);
        CHECK(i == 0 || factor == TOL_STEP_SHRINK, "factor %g", factor);
        /* The step that then succeeds is not lengthened at once. */
        assert_true(control_judge(&c, 1e-9, &factor));
        CHECK(factor == 1.0, "factor %g", factor);
        assert_true(control_judge(&c, 1e-9, &factor));
        CHECK(factor > 1.0 && factor <= TOL_STEP_GROWTH, "factor %g", factor);
    }
}

/* An error C h^k settles where the controller wants it, at a constant step. */
static void control_settles_on_a_constant_step(void **state)
{
    (void) state;
    for (double order = 3.0; order < 9.0; order += 1.0) {
        struct control c = CONTROL_INIT(order);
        double h = 1e-3, factor = 0.0;
        int rejected = 0;
        for (int i = 0; i < 200; i++) {
            rejected += !control_judge(&c, pow(2.0 * h, order), &factor);
            h *= factor;
        }
        CHECK(fabs(factor - 1.0) < 1e-6, "order %g: factor %g", order, factor);
        CHECK(pow(2.0 * h, order) > 0.05 && pow(2.0 * h, order) < 0.9,
              "order %g: error %g", order, pow(2.0 * h, order));
        CHECK(rejected <= 2, "order %g: %d rejections", order, rejected);
    }
}

static void no_error_at_all_grows_the_step_to_the_limit(void **state)
{
    struct control c = CONTROL_INIT(8.0);
    double factor = 0.0;

    (void) state;
    for (int i = 0; i < 3; i++)
        assert_true(control_judge(&c, 0.0, &factor));
    CHECK(factor > 1.2 && factor <= TOL_STEP_GROWTH, "factor %g", factor);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(errors_above_one_and_nan_are_rejected),
        cmocka_unit_test(control_settles_on_a_constant_step),
        cmocka_unit_test(no_error_at_all_grows_the_step_to_the_limit),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
