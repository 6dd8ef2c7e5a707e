/* Equilibria of systems as typed: all of them, each where it is, or boxes. */
#include <time.h>

#include "typed_system.h"

/* ---- text books ---------------------------------------------------------- */

static void the_pendulum_has_a_saddle_and_a_centre_once_round(void **state)
{
    static const struct typed pendulum = { { CHART_ANGLE, CHART_REAL },
                                           { { "d", "0.2" } },
                                           { { NULL } },
                                           { "y", "-sin(x) - d*y" } };
    const double pi = 3.14159265358979323846;

    (void) state;
    type_system(&pendulum);
    find_in(0, 0, -10, 10); /* the upper edge of an angle is not asked for */
    all_found(2, "pendulum");
    const struct system_equilibrium *saddle = at_place(pi, 0, 1e-15);
    is_type(saddle, SYSTEM_SADDLE);
    near(&saddle->eigenvalue[0].re, -0.1 - sqrt(1.01), 1e-15);
    near(&saddle->eigenvalue[1].re, -0.1 + sqrt(1.01), 1e-15);
    near(&saddle->chart[0], pi, 1.3e-16);
    const struct system_equilibrium *focus = at_place(0, 0, 0);
    is_type(focus, SYSTEM_STABLE_FOCUS);
    near(&focus->eigenvalue[0].im, -sqrt(0.99), 1e-15);
    near(&focus->eigenvalue[1].im, sqrt(0.99), 1e-15);
    find_in(-pi, 0, -10, 10); /* the saddle on both edges is one */
    all_found(2, "pendulum from -pi");
    s.state[0].period *= 1 - (formula_real) 1e-30L; /* typed to 30 digits */
    find_in(-3.14159265358979, 0, -10, 10);
    all_found(2, "pendulum between edges");
    set_to("d", 0);
    find_in(-1, 0, -1e6, 1e6);
    all_found(2, "pendulum without friction");
    is_type(at_place(0, 0, 0), SYSTEM_NONHYPERBOLIC);
}

static void fitzhugh_and_nagumo_have_one_or_three(void **state)
{
    static const struct typed fitzhugh = {
        { CHART_REAL, CHART_REAL },
        { { "I", "0.5" }, { "b", "0.8" }, { "c", "0.7" } },
        { { NULL } },
        { "x - x^3/3 - y + I", "0.08*(x + c - b*y)" }
    };

    (void) state;
    type_system(&fitzhugh);
    find_in(-10, 10, -10, 10);
    all_found(1, "FitzHugh-Nagumo");
    is_type(&found.equilibrium[0], SYSTEM_UNSTABLE_FOCUS);
    set_to("I", 0);
    set_to("b", 2);
    set_to("c", 0);
    find_in(-1e3, 1e3, -1e3, 1e3);
    all_found(3, "FitzHugh-Nagumo, three");
}

static void competing_species_are_all_found(void **state)
{
    static const struct typed lotka = { { CHART_POSITIVE, CHART_POSITIVE },
                                        { { NULL } },
                                        { { NULL } },
                                        { "x*(1 - x - 1.5*y)",
                                          "y*(1 - y - 1.7*x)" } };
    struct typed real = lotka;
    const double x = 0.5 / 1.55, y = 0.7 / 1.55;

    (void) state;
    type_system(&lotka);
    find_in(-50, 5, -50, 5);
    all_found(1, "positive");
    is_type(at_place(x, y, 1e-15), SYSTEM_SADDLE);
    real.chart[0] = real.chart[1] = CHART_REAL;
    type_system(&real);
    find_in(-0.5, 5, -0.5, 5);
    all_found(4, "real");
    is_type(at_place(0, 0, 0), SYSTEM_UNSTABLE_NODE);
    is_type(at_place(1, 0, 0), SYSTEM_STABLE_NODE);
    is_type(at_place(x, y, 1e-15), SYSTEM_SADDLE);
    near(&at_place(0, 1, 0)->eigenvalue[0].re, -1, 0);
    find_in(0, 1, 0, 1); /* three are on its edges */
    all_found(4, "on edges");
}

/* 2 - x - y = 0 is ln 2 = ln(x + y), from which there is no way back. */
static void whoever_competes_for_other_than_one_is_found(void **state)
{
    static const struct typed lotka = { { CHART_POSITIVE, CHART_POSITIVE },
                                        { { NULL } },
                                        { { NULL } },
                                        { "x*(3 - x - 2*y)",
                                          "y*(2 - x - y)" } };

    (void) state;
    type_system(&lotka);
    find_in(-5, 2, -5, 2);
    all_found(1, "Lotka and Volterra");
    is_type(at_place(1, 1, 1e-15), SYSTEM_SADDLE);
}

static void morris_and_lecar_have_three(void **state)
{
    static const struct typed lecar = {
        { CHART_REAL, CHART_REAL },
        { { "I", "35" } },
        { { "minf", "0.5*(1 + tanh((x + 1.2)/18))" },
          { "winf", "0.5*(1 + tanh((x - 12)/17.4))" } },
        { "(I - 4*minf*(x - 120) - 8*y*(x + 84) - 2*(x + 60))/20",
          "cosh((x - 12)/34.8)/15*(winf - y)" }
    };

    (void) state;
    type_system(&lecar);
    find_in(-80, 80, -1, 2);
    all_found(3, "Morris-Lecar");
    is_type(&found.equilibrium[0], SYSTEM_STABLE_NODE);
    is_type(&found.equilibrium[1], SYSTEM_SADDLE);
    find_in(-1e4, 1e4, -1e4, 1e4);
    all_found(3, "Morris-Lecar, wide");
}

static void equations_that_know_nothing_of_each_other_are_solved(void **state)
{
    static const struct typed wells = { { CHART_REAL, CHART_REAL },
                                        { { NULL } },
                                        { { NULL } },
                                        { "x - x^3", "y - y^3" } };

    (void) state;
    type_system(&wells);
    for (int i = 0; i < 3; i++) {
        find_in(-2 - 0.1 * i, 2, -2, 2 + 0.3 * i);
        all_found(9, "two wells");
    }
}

static void duffing_has_three_and_a_window_may_have_none(void **state)
{
    static const struct typed duffing = { { CHART_REAL, CHART_REAL },
                                          { { "d", "0.1" } },
                                          { { NULL } },
                                          { "y", "x - x^3 - d*y" } };

    (void) state;
    type_system(&duffing);
    find_in(-1e6, 1e6, -1e6, 1e6);
    all_found(3, "Duffing");
    is_type(at_place(0, 0, 0), SYSTEM_SADDLE);
    is_type(at_place(1, 0, 0), SYSTEM_STABLE_FOCUS);
    find_in(0.1, 0.9, -5, 5);
    all_found(0, "Duffing, none");
    find_in(-5, 5, 1e-12, 5);
    all_found(0, "Duffing, just above");
}

/* ---- where it cannot be decided ------------------------------------------ */

static double seconds(void)
{
    return (double) clock() / CLOCKS_PER_SEC;
}

/* Boxes hold the whole diagonal, and the work ends. */
static void a_line_of_equilibria_is_boxes(void **state)
{
    static const struct typed line = { { CHART_REAL, CHART_REAL },
                                       { { NULL } },
                                       { { NULL } },
                                       { "(x - y)*exp(x)", "sinh(x - y)" } };
    const double begin = seconds();

    (void) state;
    type_system(&line);
    find_in(-3, 2, -3, 2);
    assert_false(found.complete);
    assert_true(found.undecided_count <= SYSTEM_UNDECIDED);
    for (double t = -3; t <= 2; t += 0.01) {
        bool held = false;
        for (int i = 0; i < found.undecided_count; i++)
            held = held || (found.undecided[i].lo[0] <= t &&
                            t <= found.undecided[i].hi[0] &&
                            found.undecided[i].lo[1] <= t &&
                            t <= found.undecided[i].hi[1]);
        for (int i = 0; i < found.count; i++)
            held = held || (found.equilibrium[i].box[0][0] <= t &&
                            t <= found.equilibrium[i].box[0][1]);
        CHECK(held, "nothing holds (%g, %g)", t, t);
    }
    assert_int_equal(found.count, 0);
    CHECK(seconds() - begin < 5, "%g s", seconds() - begin);
}

static void two_that_meet_are_one_box_and_two_nearby_are_two(void **state)
{
    static const struct typed fold = { { CHART_REAL, CHART_REAL },
                                       { { "m", "0" } },
                                       { { NULL } },
                                       { "m + 2*x - x^2 - 1", "x - y" } };

    (void) state;
    type_system(&fold);
    find_in(-20, 15, -10, 10);
    assert_int_equal(found.count, 0);
    assert_int_equal(found.undecided_count, 1);
    assert_true(found.undecided[0].lo[0] <= 1 && found.undecided[0].hi[0] >= 1);
    assert_true(found.undecided[0].hi[0] - found.undecided[0].lo[0] < 1e-6);
    set_to("m", 1e-9);
    find_in(-20, 15, -10, 10);
    all_found(2, "beside the fold");
    const double x = sqrt(1e-9);
    is_type(at_place(1 + x, 1 + x, 1e-15), SYSTEM_STABLE_NODE);
    is_type(at_place(1 - x, 1 - x, 1e-15), SYSTEM_SADDLE);
    set_to("m", -1e-9);
    find_in(-20, 15, -10, 10);
    all_found(0, "past the fold");
}

/* What is written as a square vanishes where its root does. */
static void a_double_zero_that_is_seen_is_proved(void **state)
{
    static const struct typed square = { { CHART_REAL, CHART_REAL },
                                         { { NULL } },
                                         { { NULL } },
                                         { "-3*(x - 2)^2", "x - y" } };

    (void) state;
    type_system(&square);
    find_in(-20, 15, -10, 10);
    all_found(1, "square");
    is_type(at_place(2, 2, 0), SYSTEM_NONHYPERBOLIC);
}

static void where_rates_are_not_defined_there_is_none(void **state)
{
    static const struct typed edge = { { CHART_REAL, CHART_REAL },
                                       { { NULL } },
                                       { { NULL } },
                                       { "ln(x) - y",
                                         "sqrt(1 - x) - 1/(y + 3)" } };
    static const struct typed nowhere = { { CHART_REAL, CHART_REAL },
                                          { { "a", "-2" } },
                                          { { NULL } },
                                          { "x + ln(a)", "y" } };
    const struct system_window w = { { -1, -1 }, { 1, 1 } };

    (void) state;
    type_system(&edge);
    find_in(-5, 5, -2.5, 5);
    all_found(2, "between its edges");
    type_system(&nowhere);
    assert_int_equal(system_equilibria_find(&s, &w, &found, &why),
                     STATUS_BAD_ARGUMENT);
    assert_string_equal(why.text, "ln of a constant is not defined");
}

/* Rosenzweig and MacArthur's predators, across a line where rates are infinite:
 * one spot on it, where both are 0/0, stays open. */
static void a_pole_is_no_curve_of_equilibria(void **state)
{
    static const struct typed predators = {
        { CHART_REAL, CHART_REAL },
        { { "m", "2" }, { "h", "0.3" }, { "d", "1" } },
        { { NULL } },
        { "x*(1 - x) - y*x/(h + x)", "y*(m*x/(h + x) - d)" }
    };

    (void) state;
    type_system(&predators);
    find_in(-1, 3, -1, 3.1);
    assert_int_equal(found.count, 3);
    is_type(at_place(0.3, 0.42, 1e-16), SYSTEM_UNSTABLE_FOCUS);
    assert_int_equal(found.undecided_count, 1);
    assert_true(fabs(found.undecided[0].lo[0] + 0.3) < 1e-6 &&
                fabs(found.undecided[0].lo[1]) < 1e-6);
    find_in(-0.29, 3, -1, 3.1);
    all_found(3, "on one side");
}

static void poles_of_a_tangent_hold_none(void **state)
{
    static const struct typed slips = { { CHART_REAL, CHART_REAL },
                                        { { NULL } },
                                        { { NULL } },
                                        { "-tan(x)", "x - y" } };

    (void) state;
    type_system(&slips);
    find_in(-2, 2, -2, 2);
    all_found(1, "tangent");
    is_type(at_place(0, 0, 0), SYSTEM_STABLE_NODE);
}

/* Names that need each other twice: 2^40 factors, were they counted. */
static void shared_parts_are_not_written_out(void **state)
{
    const struct formula_place at = { "typed", 1, 1 };
    char name[20], text[60];
    const double begin = seconds();

    (void) state;
    formula_system_init(&s);
    enum status status =
        formula_system_state(&s, "x", CHART_POSITIVE, NULL, at, &why);
    if (status == STATUS_OK)
        status = formula_system_state(&s, "y", CHART_REAL, NULL, at, &why);
    for (int i = 0; i < 40 && status == STATUS_OK; i++) {
        sprintf(name, "a%d", i);
        sprintf(text, i ? "(a%d*a%d + 1)*a%d/(y + 7)" : "1 + x", i - 1, i - 1,
                i - 1);
        status = formula_system_define(&s, name, text, at, &why);
    }
    for (int i = 0; i < 40 && status == STATUS_OK; i++) {
        sprintf(name, "b%d", i);
        sprintf(text, i ? "b%d*(b%d*(2 + x))" : "1 + x", i - 1, i - 1);
        if (i < 24)
            status = formula_system_define(&s, name, text, at, &why);
    }
    if (status == STATUS_OK)
        status = formula_system_rate(&s, "x", "a39 - 2", at, &why);
    if (status == STATUS_OK)
        status = formula_system_rate(&s, "y", "b23 - 3", at, &why);
    CHECK(status == STATUS_OK, "%s", why.text);
    const struct system_window w = { { -1, -1 }, { 1, 1 } };
    status = system_equilibria_find(&s, &w, &found, &why);
    CHECK(status == STATUS_OK || status == STATUS_BAD_ARGUMENT, "%s", why.text);
    CHECK(seconds() - begin < 20, "%g s", seconds() - begin);
}

static void a_window_that_is_none_is_refused(void **state)
{
    static const struct typed plain = {
        { CHART_REAL, CHART_REAL }, { { NULL } }, { { NULL } }, { "x", "y" }
    };
    const struct system_window wrong[] = { { { 1, -1 }, { 1, 1 } },
                                           { { 0, 0 }, { 1, HUGE_VAL } },
                                           { { 0, NAN }, { 1, 1 } } };

    (void) state;
    type_system(&plain);
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++)
        assert_int_equal(system_equilibria_find(&s, &wrong[i], &found, &why),
                         STATUS_BAD_ARGUMENT);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_pendulum_has_a_saddle_and_a_centre_once_round),
        cmocka_unit_test(fitzhugh_and_nagumo_have_one_or_three),
        cmocka_unit_test(competing_species_are_all_found),
        cmocka_unit_test(whoever_competes_for_other_than_one_is_found),
        cmocka_unit_test(morris_and_lecar_have_three),
        cmocka_unit_test(equations_that_know_nothing_of_each_other_are_solved),
        cmocka_unit_test(duffing_has_three_and_a_window_may_have_none),
        cmocka_unit_test(a_line_of_equilibria_is_boxes),
        cmocka_unit_test(two_that_meet_are_one_box_and_two_nearby_are_two),
        cmocka_unit_test(a_double_zero_that_is_seen_is_proved),
        cmocka_unit_test(where_rates_are_not_defined_there_is_none),
        cmocka_unit_test(a_pole_is_no_curve_of_equilibria),
        cmocka_unit_test(poles_of_a_tangent_hold_none),
        cmocka_unit_test(shared_parts_are_not_written_out),
        cmocka_unit_test(a_window_that_is_none_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
