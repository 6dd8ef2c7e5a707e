/* What people type: read as they mean it, or blamed in one line. */
#include "parse.h"

#include <string.h>

#include "check.h"
#include "typed.h"

static int open_graph(void **state)
{
    (void) state;
    formula_init(&f);
    formula_leaf(&f, "v", FORMULA_POSITIVE_STATE);
    formula_leaf(&f, "psi", FORMULA_STATE);
    formula_leaf(&f, "R", FORMULA_POSITIVE_PARAMETER);
    return 0;
}

static void same(const char *a, const char *b)
{
    CHECK(parsed(a) == parsed(b), "%s is not %s", a, b);
}

static void operators_bind_as_everywhere(void **state)
{
    (void) state;
    same("v + psi*R", "v + (psi*R)");
    same("v - psi - R", "(v - psi) - R");
    same("v/psi/R", "(v/psi)/R");
    same("v/psi*R", "(v/psi)*R");
    same("-psi^2", "-(psi^2)");
    same("psi^-2", "psi^(-2)");
    same("psi^2^3", "psi^(2^3)");
    same("2*-psi", "-2*psi");
    same("--psi", "psi");
    same("psi^2", "psi*psi");
    same("v^psi", "exp(psi*ln(v))");
    same(" v\n\t+ R", "v+R");
    same("abs2(v + R)", "(v + R)^2");
    same("log10(v)", "ln(v)/ln(10)");
}

static void numbers_are_decimals_in_113_bits(void **state)
{
    const formula_real tenth = f.node[parsed("0.1")].number;
    const formula_real third = f.node[parsed("3e-1")].number;

    (void) state;
    assert_true(tenth * 10 == 1 && (double) tenth == 0.1);
    assert_true(third - 3 * tenth < 1e-34 && 3 * tenth - third < 1e-34);
    assert_true((double) f.node[parsed("1.5e+3")].number == 1500);
    assert_true((double) f.node[parsed(".25")].number == 0.25);
    assert_true((double) f.node[parsed("6.02214076e23")].number ==
                6.02214076e23);
    assert_true((double) f.node[parsed("pi")].number == 3.141592653589793);
    assert_true((double) f.node[parsed("1e299")].number == 1e299);
}

/* ---- complaints ---------------------------------------------------------- */

static void blamed(const char *text, const char *expected)
{
    struct fault why = { "" };
    int node = -7;
    const enum status s = formula_parse(&f, text, &node, &why);

    CHECK(s == STATUS_BAD_SCENE, "%.40s is read", text);
    assert_int_equal(node, -7);
    assert_string_equal(why.text, expected);
}

static void mistakes_are_shown_with_line_and_column(void **state)
{
    (void) state;
    blamed("", "line 1, column 1: the formula ends, expected a number, a name "
               "or (");
    blamed("v +", "line 1, column 4: the formula ends, expected a number, a "
                  "name or (");
    blamed("v\n+ * R", "line 2, column 3: '*', expected a number, a name or (");
    blamed("(v + R", "line 1, column 7: the formula ends, expected + - * / ^ "
                     "or )");
    blamed("v)", "line 1, column 2: ')', expected + - * / ^ or the end");
    blamed("v psi", "line 1, column 3: 'p', expected + - * / ^ or the end");
    blamed("v + lambda", "line 1, column 5: unknown name lambda");
    blamed("v + pso", "line 1, column 5: unknown name pso (did you mean psi?)");
    blamed("exp", "line 1, column 1: exp is a function, expected ( behind it");
    blamed("gamma(v)", "line 1, column 1: unknown function gamma");
    blamed("R*asimh(v)", "line 1, column 3: unknown function asimh (did you "
                         "mean asinh?)");
    blamed("R*abs(v)", "line 1, column 3: abs is not analytic");
    blamed("v < 1", "line 1, column 3: '<': comparisons are not analytic, "
                    "expected + - * / ^ or the end");
    blamed("1.5.", "line 1, column 4: '.', expected + - * / ^ or the end");
    blamed("v + .", "line 1, column 5: '.', expected digits");
    blamed("2e", "line 1, column 2: 'e', expected + - * / ^ or the end");
    blamed("1e301", "line 1, column 1: a number beyond 1e-300 ... 1e300");
    blamed("1e99999999999",
           "line 1, column 1: a number beyond 1e-300 ... 1e300");
    blamed("\xc3\xa4", "line 1, column 1: byte 195, expected a number, a name "
                       "or (");
}

static void a_formula_of_a_file_is_blamed_there(void **state)
{
    const struct formula_place file = { "a.yaml", 7, 12 },
                               option = { "--ode", 0, 0 };
    struct fault why = { "" };
    int node;

    (void) state;
    assert_int_equal(formula_parse_at(&f, "v + 2x", file, &node, &why),
                     STATUS_BAD_SCENE);
    assert_string_equal(why.text, "a.yaml:7: column 6 of the formula: 'x', "
                                  "expected + - * / ^ or the end");
    assert_int_equal(formula_parse_at(&f, "v +\n phi", option, &node, &why),
                     STATUS_BAD_SCENE);
    assert_string_equal(why.text,
                        "--ode: line 2, column 2 of the formula: unknown name "
                        "phi (did you mean psi?)");
    assert_int_equal(formula_blame(file, &why, "no %s", "law"),
                     STATUS_BAD_SCENE);
    assert_string_equal(why.text, "a.yaml:7:12: no law");
}

static void decimals_are_read_alone(void **state)
{
    static const char *const wrong[] = { "",    "-",     "x", "1x",
                                         "--1", "1e301", ".", "0x10",
                                         "inf", "1 2",   NULL };
    const struct formula_place none = { .line = 0 };
    formula_real value = 7;
    struct fault why;

    (void) state;
    assert_int_equal(formula_parse_decimal(" -2.5e-1 ", none, &value, &why),
                     STATUS_OK);
    assert_true(value == -0.25);
    assert_int_equal(formula_parse_decimal("+3", none, &value, &why),
                     STATUS_OK);
    assert_true(value == 3);
    for (int i = 0; wrong[i]; i++)
        CHECK(formula_parse_decimal(wrong[i], none, &value, &why) ==
                      STATUS_BAD_SCENE &&
                  value == 3,
              "'%s' is read", wrong[i]);
}

/* `count` times `word`, then the rest. */
static char *repeated(size_t count, const char *word, const char *rest)
{
    const size_t size = strlen(word);
    char *text = malloc(count * size + strlen(rest) + 1);

    assert_non_null(text);
    for (size_t i = 0; i < count; i++)
        memcpy(text + i * size, word, size);
    strcpy(text + count * size, rest);
    return text;
}

static void too_much_costs_one_line(void **state)
{
    static const struct {
        size_t count;
        const char *word, *rest, *expected;
    } cases[] = {
        { 1000, "(", "v", "line 1, column 202: more than 200 brackets" },
        { 1000, "exp(", "v", "line 1, column 805: more than 200 brackets" },
        { 1000, "v^", "v",
          "line 1, column 403: more than 200 brackets and powers" },
        { 10001, "v", "",
          "line 1, column 1: the formula is longer than 10000" },
        { 1000000, "(", "", "line 1, column 1: the formula is longer" },
        { 4000, "-", "v?", "line 1, column 4002: '?'" },
    };

    (void) state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct fault why = { "" };
        int node;
        char *text = repeated(cases[i].count, cases[i].word, cases[i].rest);
        assert_int_equal(formula_parse(&f, text, &node, &why),
                         STATUS_BAD_SCENE);
        CHECK(strncmp(why.text, cases[i].expected, strlen(cases[i].expected)) ==
                  0,
              "%s, expected %s", why.text, cases[i].expected);
        free(text);
    }
}

static void a_formula_of_too_many_parts_is_refused(void **state)
{
    char text[PARSE_LETTERS + 1] = "0";
    struct fault why;
    int node;

    (void) state;
    for (int i = 2; strlen(text) < 3000; i++)
        sprintf(text + strlen(text), "+%d*v/psi", i);
    assert_int_equal(formula_parse(&f, text, &node, &why), STATUS_OK);
    strcpy(text, "0");
    for (int i = 2; strlen(text) < sizeof text - 12; i++)
        sprintf(text + strlen(text), "+%d/(v+%d)", i, i);
    assert_int_equal(formula_parse(&f, text, &node, &why), STATUS_BAD_SCENE);
    assert_string_equal(why.text, "line 1, column 1: the formula has more than "
                                  "2048 parts");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(operators_bind_as_everywhere, open_graph),
        cmocka_unit_test_setup(numbers_are_decimals_in_113_bits, open_graph),
        cmocka_unit_test_setup(mistakes_are_shown_with_line_and_column,
                               open_graph),
        cmocka_unit_test_setup(a_formula_of_a_file_is_blamed_there, open_graph),
        cmocka_unit_test_setup(decimals_are_read_alone, open_graph),
        cmocka_unit_test_setup(too_much_costs_one_line, open_graph),
        cmocka_unit_test_setup(a_formula_of_too_many_parts_is_refused,
                               open_graph),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
