/* What the steps of a landing are taken to have missed. */
#include "landing_weigh.h"

#include <math.h>

#include "check.h"
#include "slow_tolerance.h"

enum { STEPS = 3 };
static const struct landing_slope slope = { 7.0, -3.0 };

/* Three steps alike, each of which missed `across` of its size. */
static void alike(double across, double part, struct landing_step step[])
{
    for (int k = 0; k < STEPS; k++)
        step[k] = (struct landing_step){ .across = across,
                                         .size = 1e-9,
                                         .part = part,
                                         .length = 0.5,
                                         .left = 1.0 };
}

static struct landing_bar weigh(struct landing_step step[])
{
    struct layer out = { .steps = STEPS };
    const struct landing l = { .step = step, .out = &out };

    return landing_weigh(&l, &slope, 0.0);
}

static void check_close(double told, double expected)
{
    CHECK(fabs(told - expected) <= 1e-14 * expected, "%g, not %g", told,
          expected);
}

static void an_estimate_along_the_orbit_may_be_a_miss_across(void **state)
{
    struct landing_step step[STEPS];

    (void) state;
    alike(0.0, 0.1, step);
    const struct landing_bar bar = weigh(step);
    check_close(bar.time, STEPS * TOL_LAYER_TURN * 1e-9 * 7.0);
    check_close(bar.slip, STEPS * TOL_LAYER_TURN * 1e-9 * 3.0);
}

/* The step in the middle, of twice the length, told a thousandth. */
static void a_step_misses_no_less_than_its_neighbours_say(void **state)
{
    struct landing_step step[STEPS];

    (void) state;
    alike(1e-9, 0.1, step);
    step[1].length = 1.0;
    step[1].part = 8.0 * 0.1;
    const struct landing_bar even = weigh(step);
    step[1].across *= 1e-3;
    step[1].size *= 1e-3;
    step[1].part *= 1e-3;
    const struct landing_bar odd = weigh(step);
    check_close(odd.time, even.time);
    check_close(odd.slip, even.slip);
    check_close(odd.more, even.more);
}

static void neighbours_that_are_rounding_say_nothing(void **state)
{
    struct landing_step step[STEPS];

    (void) state;
    alike(0.0, 0.1, step);
    step[0] = step[2] = (struct landing_step){ .part = TOL_LAYER_MISSED_MOST,
                                               .length = 0.5,
                                               .left = 1.0 };
    const struct landing_bar bar = weigh(step);
    check_close(bar.time, TOL_LAYER_TURN * 1e-9 * 7.0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_estimate_along_the_orbit_may_be_a_miss_across),
        cmocka_unit_test(a_step_misses_no_less_than_its_neighbours_say),
        cmocka_unit_test(neighbours_that_are_rounding_say_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
