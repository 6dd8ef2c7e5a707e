/* Lines: brackets where they must be, names for what is repeated, constants
 * apart from what changes. */
#include "lines.h"

#include <string.h>

#include "check.h"
#include "typed.h"

static struct text_lines out;

static int open_graph(void **state)
{
    (void) state;
    formula_init(&f);
    formula_leaf(&f, "u", FORMULA_STATE);
    formula_leaf(&f, "w", FORMULA_STATE);
    formula_leaf(&f, "p", FORMULA_POSITIVE_PARAMETER);
    return 0;
}

static void written(const char *typed, const char *expected)
{
    int node = -1;

    open_graph(NULL);
    node = parsed(typed);
    formula_name(&f, node, "it");
    assert_true(text_write(&f, &node, 1, &out));
    assert_int_equal(out.lines, 1);
    assert_string_equal(out.line[0].name, "it");
    assert_string_equal(out.line[0].text, expected);
}

static void brackets_stand_where_they_must_and_nowhere_else(void **state)
{
    (void) state;
    written("(u+w)*(u-3*w)", "(u+w)*(u-3*w)");
    written("u - (w + 2*w*w)", "u-(w+2*(w*w))");
    written("u/w/(w/u)", "u/w/(w/u)");
    written("u/w*u", "u/w*u");
    written("u*(u/w)", "u*(u/w)");
    written("u/w+2", "u/w+2");
    written("-2*u", "-2*u");
    written("-(u+w)", "-(u+w)");
    written("w - u", "w-u");
    written("-u - w", "(-u)-w");
    written("exp(u+w)/sinh(-u)", "exp(u+w)/sinh((-u))");
    written("u*(-w)", "-(u*w)");
    written("u + 0.1", "u+0.1");
    written("u^3", "power(u,3)");
}

static bool has_line(const char *name, const char *text, bool moves)
{
    for (size_t i = 0; i < out.lines; i++)
        if (strcmp(out.line[i].name, name) == 0 &&
            strcmp(out.line[i].text, text) == 0 && out.line[i].moves == moves)
            return true;
    return false;
}

static void what_is_repeated_and_what_is_constant_gets_a_line(void **state)
{
    int node = parsed("sinh(u*w)/(exp(2*p)*u + sinh(u*w))");

    (void) state;
    formula_name(&f, node, "it");
    assert_true(text_write(&f, &node, 1, &out));
    assert_true(has_line("k2", "exp(2*p)", false));
    assert_true(has_line("k1", "sinh(u*w)", true));
    assert_true(has_line("it", "k1/(k2*u+k1)", true));
    assert_int_equal(out.lines, 3);
    assert_true(out.uses[formula_find(&f, "u", 1)]);
    assert_false(out.calls[FUNCTION_SINH]); /* it has no body */
}

static void only_what_is_needed_is_written(void **state)
{
    int node = parsed("asinh(u)");

    (void) state;
    formula_name(&f, parsed("w*w"), "unused");
    formula_name(&f, node, "it");
    assert_true(text_write(&f, &node, 1, &out));
    assert_int_equal(out.lines, 1);
    assert_false(out.uses[formula_find(&f, "w", 1)]);
    assert_true(out.calls[FUNCTION_ASINH] && out.calls[FUNCTION_LN1P]);
    assert_false(out.calls[FUNCTION_EM1]);
}

static void a_line_that_does_not_fit_is_refused(void **state)
{
    int node = 0;

    (void) state;
    for (int i = 1; i < 120; i++)
        node = formula_sum(&f, node,
                           formula_over(&f, formula_number(&f, i + 0.1),
                                        formula_find(&f, "u", 1)));
    for (int i = 1; i < 120; i++)
        node = formula_times(&f, formula_sum(&f, node, formula_number(&f, i)),
                             formula_find(&f, "w", 1));
    formula_name(&f, node, "it");
    assert_false(text_write(&f, &node, 1, &out));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(brackets_stand_where_they_must_and_nowhere_else,
                               open_graph),
        cmocka_unit_test_setup(
            what_is_repeated_and_what_is_constant_gets_a_line, open_graph),
        cmocka_unit_test_setup(only_what_is_needed_is_written, open_graph),
        cmocka_unit_test_setup(a_line_that_does_not_fit_is_refused, open_graph),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
