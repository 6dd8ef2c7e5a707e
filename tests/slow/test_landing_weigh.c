/* What the steps of a landing are taken to have missed. */
#include "landing_weigh.h"

#include <math.h>

#include "landing_halves.h"
#include "place.h"
#include "slow_tolerance.h"

enum { STEPS = 3 };
static const struct landing_slope slope = { 7.0, -3.0 };

static struct landing_bar weigh(struct landing_step step[])
{
    struct layer out = { .steps = STEPS };
    struct place p;

    place_make(&p, "spinodal_gen", "0.34");
    const struct landing l = { .curve = &p.c, .step = step, .out = &out };
    const struct landing_bar bar = landing_weigh(&l, &slope, 0.0);
    place_drop(&p);
    return bar;
}

static void check_close(double told, double expected)
{
    CHECK(fabs(told - expected) <= 1e-14 * expected, "%g, not %g", told,
          expected);
}

/* A step of no length, halves of which differ by nothing, and what one misses
 * of a term that stands alone. */
static const struct landing_step exact = { .from = { 3.0, 1.0 }, .left = 1.0 };
static const double alone = TOL_LAYER_MISSED * TOL_LAYER_FALL;

/* Of an integral, whose term of order 4 is estimated by a tenth. */
static void terms_that_fall_like_powers_miss_their_cube(void **state)
{
    (void) state;
    for (double r = 0.01; r < 2.0; r *= 1.5) {
        const double six = pow(r, 6.0);
        const double size[LANDING_TERMS] = { six, six, r * six,
                                             0.1 * six / r / r };
        check_close(landing_missed(size, 0.0), TOL_LAYER_MISSED * r * r * r);
    }
}

static void a_term_of_order_6_that_vanishes_says_nothing_of_their_fall(
    void **state)
{
    const double size[LANDING_TERMS] = { 1e-9, 1e-9, 1e-7, 1e-4 };

    (void) state;
    check_close(landing_missed(size, 0.0), TOL_LAYER_MISSED * 1e-3);
    check_close(landing_missed(size, 1e-6), TOL_LAYER_MISSED * 1e-2);
}

static void an_estimate_that_vanishes_is_outdone_by_the_others(void **state)
{
    (void) state;
    for (int n = 0; n < EXPLICIT8_TERMS; n++) {
        struct landing_step step[STEPS] = { exact, exact, exact };
        step[1].across[n] = 1e-9;
        const struct landing_bar bar = weigh(step);
        check_close(bar.time, alone * 1e-9 * 7.0);
        check_close(bar.slip, alone * 1e-9 * 3.0);
    }
}

/* Late by as much as it lies aside, by every estimate but one. */
static void what_is_late_for_being_aside_is_not_late(void **state)
{
    struct landing_step step[STEPS] = { exact, exact, exact };

    (void) state;
    for (int n = 0; n < EXPLICIT8_TERMS; n++) {
        step[2].across[n] = 1e-9;
        step[2].time[n] = -7e-9;
    }
    CHECK(weigh(step).time <= 1e-24, "%g", weigh(step).time);
    step[2].time[0] = -6e-9;
    check_close(weigh(step).time, alone * 1e-9);
}

/* The last step leaves half of what is across, and takes it 2 longer. */
static void what_steps_make_of_a_miss_is_known_to_a_part(void **state)
{
    struct landing_step step[STEPS] = { exact, exact, exact };

    (void) state;
    step[1].across[0] = 1e-9;
    step[2].left = 0.5;
    step[2].time_gain = 2.0;
    check_close(weigh(step).time,
                alone * 1e-9 * (2.0 + 3.5 + TOL_LAYER_BLUR * (2.0 + 3.5)));
}

/* A place, and a step there. */
static const struct vec2 start = { 3.0, 1.0 };
static const double length = 0.5;

static void halves_differ_by_the_ninth_power_of_the_step(void **state)
{
    struct place p;

    (void) state;
    place_make(&p, "spinodal_gen", "0.34");
    const struct landing_halves whole =
        landing_halve(&p.s.study.slider, start, length);
    const struct landing_halves half =
        landing_halve(&p.s.study.slider, start, 0.5 * length);
    const double r[] = { whole.across / half.across, whole.time / half.time,
                         whole.slip / half.slip };
    for (int i = 0; i < 3; i++)
        CHECK(r[i] > 256.0 && r[i] < 1024.0, "%d: %g", i, r[i]);
    place_drop(&p);
}

static void a_step_of_most_of_a_sum_is_halved(void **state)
{
    struct landing_step step[STEPS] = { exact, exact, exact };
    struct layer out = { .steps = STEPS };
    struct place p;

    (void) state;
    place_make(&p, "spinodal_gen", "0.34");
    const struct landing l = { .curve = &p.c, .step = step, .out = &out };
    const struct landing_halves d =
        landing_halve(&p.s.study.slider, start, length);
    step[1].from = start;
    step[1].h = length;
    step[1].across[0] = step[1].across[1] = 1e-25;
    step[1].across[2] = 1e-20;
    step[1].across[LANDING_FOURTH] = 1e-17;
    const struct landing_bar bar = landing_weigh(&l, &slope, 0.0);
    check_close(bar.time, 2.0 * fabs(d.time + 7.0 * d.across));
    check_close(bar.slip, 2.0 * fabs(d.slip - 3.0 * d.across));
    step[2].across[0] = 1e-20;
    const double largest = alone * 1e-20 * 7.0;
    const double time = landing_weigh(&l, &slope, 0.0).time;
    CHECK(time > largest && time < 1.001 * largest, "%g", time);
    place_drop(&p);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(terms_that_fall_like_powers_miss_their_cube),
        cmocka_unit_test(
            a_term_of_order_6_that_vanishes_says_nothing_of_their_fall),
        cmocka_unit_test(an_estimate_that_vanishes_is_outdone_by_the_others),
        cmocka_unit_test(what_is_late_for_being_aside_is_not_late),
        cmocka_unit_test(what_steps_make_of_a_miss_is_known_to_a_part),
        cmocka_unit_test(halves_differ_by_the_ninth_power_of_the_step),
        cmocka_unit_test(a_step_of_most_of_a_sum_is_halved),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
