/* The graph: what is folded, what is shared, what is known of a node. */
#include "formula.h"

#include <string.h>

#include "check.h"

static struct formula f;
static int u, w, v, p; /* two that may be negative, two that are positive */

static int open_graph(void **state)
{
    (void) state;
    formula_init(&f);
    u = formula_leaf(&f, "u", FORMULA_PARAMETER);
    w = formula_leaf(&f, "w", FORMULA_STATE);
    v = formula_leaf(&f, "v", FORMULA_POSITIVE_STATE);
    p = formula_leaf(&f, "p", FORMULA_POSITIVE_PARAMETER);
    return 0;
}

static int number(double x)
{
    return formula_number(&f, x);
}

static void numbers_are_folded(void **state)
{
    (void) state;
    assert_int_equal(formula_sum(&f, number(0), u), u);
    assert_int_equal(formula_less(&f, u, number(0)), u);
    assert_int_equal(formula_times(&f, u, number(1)), u);
    assert_int_equal(formula_over(&f, u, number(1)), u);
    assert_int_equal(formula_times(&f, u, number(0)), number(0));
    assert_int_equal(formula_sum(&f, number(2), number(3)), number(5));
    assert_int_equal(
        formula_times(&f, number(2), formula_times(&f, u, number(3))),
        formula_times(&f, number(6), u));
    assert_int_equal(formula_over(&f, u, number(4)),
                     formula_times(&f, number(0.25), u));
    assert_int_equal(formula_of(&f, FUNCTION_EXP, number(0)), number(1));
}

static void what_cancels_is_gone(void **state)
{
    const int sum = formula_sum(&f, formula_sum(&f, u, w), v);
    int rest;

    (void) state;
    assert_int_equal(formula_less(&f, u, u), number(0));
    assert_int_equal(formula_over(&f, w, w), number(1));
    assert_int_equal(formula_less(&f, sum, w), formula_sum(&f, u, v));
    assert_int_equal(formula_less(&f, formula_sum(&f, v, u), sum),
                     formula_less(&f, 0, w));
    assert_int_equal(formula_sum(&f, formula_less(&f, 0, sum), w),
                     formula_less(&f, 0, formula_sum(&f, u, v)));
    assert_int_equal(formula_sum(&f, u, u), formula_times(&f, number(2), u));
    assert_true(formula_factor(&f, formula_sum(&f, sum, w), &rest) == 1);
    assert_int_equal(
        formula_of(&f, FUNCTION_LN, formula_of(&f, FUNCTION_EXP, sum)), sum);
    const int less = formula_of(&f, FUNCTION_EXP, formula_less(&f, 0, u));
    assert_int_equal(
        less, formula_over(&f, number(1), formula_of(&f, FUNCTION_EXP, u)));
    assert_int_equal(formula_of(&f, FUNCTION_LN, less), formula_less(&f, 0, u));
}

static void what_is_there_already_is_not_made_again(void **state)
{
    const int a = formula_over(&f, u, w), before = f.nodes;

    (void) state;
    assert_int_equal(
        formula_over(&f, formula_leaf(&f, "u", FORMULA_PARAMETER), w), a);
    assert_int_equal(f.nodes, before);
    assert_int_not_equal(formula_over(&f, w, u), a);
}

static void signs_follow_from_the_form(void **state)
{
    const int exponential = formula_of(&f, FUNCTION_EXP, w),
              sum = formula_sum(&f, v, p), square = formula_times(&f, u, u),
              moving = formula_times(&f, w, w);

    (void) state;
    assert_true(f.node[exponential].positive && f.node[exponential].natural);
    assert_true(f.node[sum].positive && !f.node[sum].natural);
    assert_true(f.node[formula_times(&f, sum, v)].natural);
    assert_true(f.node[square].positive && !f.node[moving].positive);
    assert_false(f.node[formula_less(&f, v, p)].positive);
    assert_false(f.node[formula_of(&f, FUNCTION_LN, v)].positive);
    assert_true(f.node[sum].moves && !f.node[square].moves);
    assert_true(f.node[formula_of(&f, FUNCTION_SINH, v)].positive);
    assert_false(f.node[formula_of(&f, FUNCTION_SINH, w)].positive);
}

static void names_are_found_and_written_once(void **state)
{
    const int sum = formula_sum(&f, v, w), square = formula_times(&f, u, u);

    (void) state;
    formula_define(&f, "sum", sum);
    formula_define(&f, "again", sum);
    formula_define(&f, "square", square);
    assert_int_equal(formula_find(&f, "again", 5), sum);
    assert_int_equal(formula_find(&f, "sum", 3), sum);
    assert_int_equal(formula_find(&f, "v", 1), v);
    assert_int_equal(formula_find(&f, "su", 2), -1);
    assert_string_equal(f.node[sum].name, ""); /* it changes */
    assert_string_equal(f.node[square].name, "square");
    formula_name(&f, sum, "SQUARE"); /* taken, but for capitals */
    assert_string_equal(f.node[sum].name, "");
    formula_define(&f, "v", u);
    assert_int_equal(formula_find(&f, "v", 1), u);
}

/* w (p v)^3 - v = v (w p (p v)^2 - 1) */
static void factors_are_taken_out_of_powers(void **state)
{
    const int pv = formula_times(&f, p, v);
    const int cube = formula_call(&f, FUNCTION_POWER, (int[]){ pv, number(3) }),
              square =
                  formula_call(&f, FUNCTION_POWER, (int[]){ pv, number(2) });
    int out;

    (void) state;
    assert_true(formula_take_out(
        &f, formula_less(&f, formula_times(&f, w, cube), v), v, &out));
    assert_int_equal(
        out,
        formula_less(&f, formula_times(&f, formula_times(&f, p, square), w),
                     number(1)));
    assert_false(formula_take_out(&f, cube, w, &out));
}

static void a_full_graph_says_so(void **state)
{
    (void) state;
    for (int i = 0; i < FORMULA_NODES && !f.full; i++)
        formula_of(&f, FUNCTION_SINH, f.nodes - 1);
    assert_true(f.full);
    assert_int_equal(f.nodes, FORMULA_NODES);
    assert_int_equal(formula_of(&f, FUNCTION_TAN, u), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(numbers_are_folded, open_graph),
        cmocka_unit_test_setup(what_cancels_is_gone, open_graph),
        cmocka_unit_test_setup(what_is_there_already_is_not_made_again,
                               open_graph),
        cmocka_unit_test_setup(signs_follow_from_the_form, open_graph),
        cmocka_unit_test_setup(names_are_found_and_written_once, open_graph),
        cmocka_unit_test_setup(factors_are_taken_out_of_powers, open_graph),
        cmocka_unit_test_setup(a_full_graph_says_so, open_graph),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
