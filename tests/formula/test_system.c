/* Systems as people type them: kept with their names, or blamed in one line. */
#include "system.h"

#include <stdio.h>
#include <string.h>

#include "check.h"

static struct formula_system s;
static struct fault why;
static const struct formula_place at = { "a.yaml", 4, 9 };

#define GOOD(call) CHECK((call) == STATUS_OK, "%s", why.text)

static int open_system(void **state)
{
    (void) state;
    formula_system_init(&s);
    GOOD(formula_system_state(&s, "x", CHART_REAL, NULL, at, &why));
    GOOD(formula_system_state(&s, "v", CHART_POSITIVE, NULL, at, &why));
    GOOD(formula_system_parameter(&s, "eps", "0.1", at, &why));
    GOOD(formula_system_parameter(&s, "beta", "-3", at, &why));
    GOOD(formula_system_define(&s, "w", "x - x^3", at, &why));
    GOOD(formula_system_rate(&s, "v", "v*(x - beta*v)", at, &why));
    return 0;
}

static void names_are_kept_with_what_they_mean(void **state)
{
    struct formula *f = &s.graph;

    (void) state;
    GOOD(formula_system_rate(&s, "x", "(w - v)/eps", at, &why));
    GOOD(formula_system_observable(&s, "slip", "v", "m", "slip of the block",
                                   at, &why));
    GOOD(formula_system_finish(&s, at, &why));
    assert_int_equal(formula_system_find_state(&s, "v"), 1);
    assert_int_equal(formula_system_find_parameter(&s, "beta"), 1);
    assert_int_equal(formula_system_find_parameter(&s, "v"), -1);
    assert_int_equal(s.observable[0].node, s.state[1].node);
    assert_string_equal(s.observable[0].unit, "m");
    assert_true(s.parameter[0].value * 10 == 1);
    assert_true(f->node[s.state[1].node].positive);
    assert_true(f->node[s.parameter[0].node].positive);
    assert_false(f->node[s.parameter[1].node].positive);
    int node = -1;
    GOOD(formula_parse(f, "(x - x^3 - v)/eps", &node, &why));
    assert_int_equal(node, s.rate[0]);
    assert_string_equal(formula_system_text(&s, &s.entry[2]), "(w - v)/eps");
}

static void an_angle_has_a_period(void **state)
{
    (void) state;
    formula_system_init(&s);
    GOOD(formula_system_state(&s, "q", CHART_ANGLE, NULL, at, &why));
    GOOD(formula_system_state(&s, "p", CHART_ANGLE, "0.5", at, &why));
    assert_true((double) s.state[0].period == 6.283185307179586);
    assert_true(s.state[1].period == 0.5);
}

static void rates_of_an_angle_are_the_same_after_its_period(void **state)
{
    (void) state;
    formula_system_init(&s);
    GOOD(formula_system_state(&s, "q", CHART_ANGLE, NULL, at, &why));
    GOOD(formula_system_state(&s, "p", CHART_REAL, NULL, at, &why));
    GOOD(formula_system_parameter(&s, "n", "2", at, &why));
    GOOD(formula_system_rate(&s, "q", "p", at, &why));
    GOOD(formula_system_rate(&s, "p", "-sin(n*q)^3 - p/10", at, &why));
    GOOD(formula_system_finish(&s, at, &why));
    GOOD(formula_system_set(&s, "n", 1.5, at, &why));
    assert_int_equal(formula_system_finish(&s, at, &why), STATUS_BAD_SCENE);
    assert_string_equal(why.text, "a.yaml:4:9: angle q: the rates are not the "
                                  "same after 6.28318531");
}

/* A parameter that is no longer positive takes with it what was read so. */
static void a_parameter_may_change_its_sign(void **state)
{
    (void) state;
    GOOD(formula_system_rate(&s, "x", "w + exp(ln(eps)*x)", at, &why));
    const int before = s.graph.nodes;
    GOOD(formula_system_set(&s, "eps", (formula_real) 0.2, at, &why));
    assert_int_equal(s.graph.nodes, before);
    GOOD(formula_system_set(&s, "eps", -(formula_real) 0.2, at, &why));
    assert_false(s.graph.node[s.parameter[0].node].positive);
    GOOD(formula_system_finish(&s, at, &why));
    GOOD(formula_system_set(&s, "eps", (formula_real) 0.1, at, &why));
    assert_true(s.graph.node[s.parameter[0].node].positive);
    assert_int_equal(s.graph.definitions, 1);
    int node = -1;
    GOOD(formula_parse(&s.graph, "x - x^3 + exp(ln(eps)*x)", &node, &why));
    assert_int_equal(node, s.rate[0]);
}

/* Only what is whole stands in the graph as a number. */
static void whole_parameters_are_exponents_of_any_number(void **state)
{
    static const struct {
        double n;
        const char *same;
    } cases[] = { { 3, "x^3" }, { 2.5, NULL }, { -1, "1/x" },
                  { 0, "1" },   { 1, "x" },    { -9999.5, NULL },
                  { 2, "x*x" }, { 1e5, NULL }, { -4, "1/x^4" } };

    (void) state;
    GOOD(formula_system_parameter(&s, "n", "7", at, &why));
    GOOD(formula_system_define(&s, "p", "x^((2*n + n)/3)", at, &why));
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        GOOD(formula_system_set(&s, "n", cases[i].n, at, &why));
        const int p = formula_find(&s.graph, "p", 1), w = s.graph.node[p].of[1];
        int same;
        GOOD(formula_parse(&s.graph, cases[i].same ? cases[i].same : "x", &same,
                           &why));
        assert_true(cases[i].same ? p == same
                                  : s.graph.node[w].kind != FORMULA_NUMBER);
    }
}

/* Many names, each of which has the one before twice. */
static void exponents_of_exponents_end(void **state)
{
    char name[8] = "n", text[24];

    (void) state;
    GOOD(formula_system_parameter(&s, "n", "2", at, &why));
    for (int i = 0; i < 60; i++) {
        snprintf(text, sizeof text, "%s - %s/2", name, name);
        snprintf(name, sizeof name, "n%d", i);
        GOOD(formula_system_define(&s, name, text, at, &why));
    }
    snprintf(text, sizeof text, "x^(%s*%s)", name, name);
    GOOD(formula_system_rate(&s, "x", text, at, &why));
}

#define BLAMED(call, expected)                                                 \
    do {                                                                       \
        assert_int_equal(call, STATUS_BAD_SCENE);                              \
        assert_string_equal(why.text, expected);                               \
    } while (0)

static void names_that_cannot_be_are_blamed_where_they_stand(void **state)
{
    (void) state;
    BLAMED(formula_system_state(&s, "z", CHART_REAL, NULL, at, &why),
           "a.yaml:4:9: state z is the third, expected two");
    BLAMED(formula_system_parameter(&s, "v", "1", at, &why),
           "a.yaml:4:9: parameter v: there is one of this name");
    BLAMED(formula_system_parameter(&s, "ln", "1", at, &why),
           "a.yaml:4:9: parameter ln: formulas have ln already");
    BLAMED(formula_system_parameter(&s, "2a", "1", at, &why),
           "a.yaml:4:9: parameter '2a', expected a name of letters, digits and "
           "_ that begins with a letter");
    BLAMED(formula_system_parameter(&s, "a234567890123456789012345678901", "k",
                                    at, &why),
           "a.yaml:4: column 1 of the formula: 'k', expected a decimal");
    BLAMED(formula_system_parameter(&s, "a2345678901234567890123456789012", "k",
                                    at, &why),
           "a.yaml:4:9: parameter a2345678901234567890...: longer than 31 "
           "letters");
    BLAMED(formula_system_define(&s, "u", "x + epz", at, &why),
           "a.yaml:4: column 5 of the formula: unknown name epz (did you mean "
           "eps?)");
    BLAMED(formula_system_define(&s, "w", "x", at, &why),
           "a.yaml:4:9: name w: there is one of this name");
    BLAMED(formula_system_rate(&s, "v", "x", at, &why),
           "a.yaml:4:9: rate of v: there is one already");
    BLAMED(formula_system_rate(&s, "y", "x", at, &why),
           "a.yaml:4:9: rate of y, which is no state");
    BLAMED(formula_system_observable(&s, "v", "x", NULL, NULL, at, &why),
           "a.yaml:4:9: observable v: orbits have v of their own");
    BLAMED(formula_system_finish(&s, at, &why),
           "a.yaml:4:9: state x has no rate");
    BLAMED(formula_system_set(&s, "betta", 1, at, &why),
           "a.yaml:4:9: unknown parameter betta (did you mean beta?)");
}

static void a_system_is_as_it_was_after_a_blame(void **state)
{
    char text[PARSE_LETTERS + 1] = "0";
    const int nodes = s.graph.nodes, entries = s.entries;

    (void) state;
    for (int i = 2; strlen(text) < sizeof text - 14; i++)
        sprintf(text + strlen(text), "+%d/(v+%d)", i, i);
    BLAMED(formula_system_rate(&s, "x", text, at, &why),
           "a.yaml:4: column 1 of the formula: the formula has more than 2048 "
           "parts");
    assert_int_equal(s.graph.nodes, nodes);
    assert_int_equal(s.entries, entries);
    GOOD(formula_system_rate(&s, "x", "v", at, &why));
    GOOD(formula_system_finish(&s, at, &why));
}

static void tables_that_are_full_are_blamed(void **state)
{
    char name[20];

    (void) state;
    for (int i = s.parameters; i < SYSTEM_PARAMETERS; i++) {
        sprintf(name, "p%d", i);
        GOOD(formula_system_parameter(&s, name, "1", at, &why));
    }
    BLAMED(formula_system_parameter(&s, "p", "1", at, &why),
           "a.yaml:4:9: more than 100 parameters");
    for (int i = 1; i < FORMULA_DEFINITIONS; i++) {
        sprintf(name, "d%d", i);
        GOOD(formula_system_define(&s, name, "x", at, &why));
    }
    BLAMED(formula_system_define(&s, "d", "x", at, &why),
           "a.yaml:4:9: more than 64 names for expressions");
    for (int i = 0; i < SYSTEM_OBSERVABLES; i++) {
        sprintf(name, "o%d", i);
        GOOD(formula_system_observable(&s, name, "x", NULL, NULL, at, &why));
    }
    BLAMED(formula_system_observable(&s, "o", "x", NULL, NULL, at, &why),
           "a.yaml:4:9: more than 8 observables");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(names_are_kept_with_what_they_mean, open_system),
        cmocka_unit_test(an_angle_has_a_period),
        cmocka_unit_test(rates_of_an_angle_are_the_same_after_its_period),
        cmocka_unit_test_setup(a_parameter_may_change_its_sign, open_system),
        cmocka_unit_test_setup(whole_parameters_are_exponents_of_any_number,
                               open_system),
        cmocka_unit_test_setup(exponents_of_exponents_end, open_system),
        cmocka_unit_test_setup(names_that_cannot_be_are_blamed_where_they_stand,
                               open_system),
        cmocka_unit_test_setup(a_system_is_as_it_was_after_a_blame,
                               open_system),
        cmocka_unit_test_setup(tables_that_are_full_are_blamed, open_system),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
