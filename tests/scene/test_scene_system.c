/* Scenes with a system of formulas: what is read, and the line of blame. */
#include "scene_system.h"

#include <math.h>

#include "scenes.h"
#include "system.h"

#define COUNT(array) (sizeof(array) / sizeof *(array))

static const char oscillator[] =
    "title: two states\n"
    "system:\n"
    "  state: {x: real, q: {angle: 3}}\n"
    "  parameters: {eps: 0.1, beta: 3}\n"
    "  define: {w: x - x^3, h: sin(2*pi*q/3)}\n"
    "  rates: {x: (w - h)/eps, q: x - beta*h}\n"
    "  observables: {path: x, work: {rate: x*h, unit: J, long_name: done}}\n"
    "window: {x: [-1.5, 2], q: [-1, 1], axes: linear}\n"
    "products: [equilibria, manifolds]\n"
    "trajectories: {starts: [{q: 0.5, x: -1}], spread: 3}\n";

static void all_of_a_system_is_read(void **state)
{
    struct scene c = scene_made(oscillator, "system.parameters.eps=0.25\n"
                                            "window.x=[-1.5, 3]\n");
    const struct formula_system *s = c.system;

    (void) state;
    assert_non_null(s);
    assert_string_equal(s->state[0].name, "x");
    assert_int_equal(s->state[1].chart, CHART_ANGLE);
    assert_true(s->state[1].period == 3);
    assert_int_equal(s->parameters, 2);
    assert_true(s->parameter[formula_system_find_parameter(s, "eps")].value ==
                0.25);
    assert_int_equal(s->observables, 2);
    assert_string_equal(s->observable[1].unit, "J");
    assert_true(c.window.v[0] == -1.5 && c.window.v[1] == 3);
    assert_true(c.window.psi[0] == -1 && c.window.psi[1] == 1);
    assert_int_equal(c.starts, 1);
    assert_true(c.start[0].v == -1 && c.start[0].psi == 0.5);
    assert_int_equal(c.spread, 3);
    const struct box w = scene_box(&c);
    assert_true(w.lo.x == -1.5 && w.hi.y == 1);
    scene_free(&c);
}

static void one_text_says_all(void **state)
{
    struct scene c =
        scene_made(NULL, "system.ode=\"dx/dt = y*k; y' = -z; k = 2; z = x/k\"\n"
                         "system.parameters.k=5\nsystem.state.y=positive\n"
                         "window={x: [-1, 1], y: [0.5, 2]}\n");

    (void) state;
    assert_int_equal(c.system->states, 2);
    assert_int_equal(c.system->parameters, 1);
    assert_true(c.system->parameter[0].value == 5);
    assert_int_equal(c.system->state[1].chart, CHART_POSITIVE);
    assert_true(scene_axis_is_log(&c, 1) && !scene_axis_is_log(&c, 0));
    assert_true(scene_box(&c).lo.y == log(0.5));
    scene_free(&c);
}

#define RATES  "system: {rates: {x: y, y: -x}}\n"
#define WINDOW "window: {x: [-1, 1], y: [-1, 1]}\n"

/* What follows the name of the file. */
static const struct {
    const char *text, *line;
} wrong[] = {
    { "system: 7\n", "1:9: system: '7' is not allowed, expected {state: ..., "
                     "parameters: ..., rates: ...}" },
    { "system: {rate: {x: y}}\n",
      "1:10: unknown key 'system.rate', expected state, parameters, define, "
      "rates, observables or ode (did you mean rates?)" },
    { "system: {rates: {x: 1}}\n", "1:9: 1 state, expected two" },
    { "system: {rates: {x: 1, y: 1, z: 1}}\n",
      "1:9: state z is the third, expected two" },
    { "system: {state: {x: positiv, y: real}, rates: {x: 1, y: 1}}\n",
      "1:21: system.state.x: 'positiv' is not allowed, expected real, "
      "positive, angle or {angle: PERIOD}" },
    { "system:\n  rates: {x: y + siin(x), y: -x}\n",
      "2: column 5 of the formula: unknown function siin (did you mean sin?)" },
    { "system:\n  rates: {x: 'y + abs(x)', y: -x}\n",
      "2: column 5 of the formula: abs is not analytic" },
    { "system: {parameters: {a: b}, rates: {x: y, y: x}}\n",
      "1:26: system.parameters.a: 'b' is not allowed, expected a number" },
    { "system: {ode: \"x' = x\"}\n", "1:9: 1 state, expected two" },
    { "system: {parameters: {a: 1, b: 2}, rates: {x: a*y, y: x}}\n",
      "1:29: system.parameters.b: no formula has it" },
    { "system: {state: {x: real, time: real}, rates: {x: 1, time: x}}\n",
      "1:33: state time: results have time of their own" },
    { "system: {ode: \"x' y\"}\n",
      "1:15: system.ode: 'x' y', expected at most 64 of NAME' = FORMULA or "
      "NAME = FORMULA, with ; between them" },
    { RATES "law: {preset: ruina}\n",
      "2:1: law: not beside system, expected one of the two" },
    { RATES "window: {x: [-1, 1], z: [-1, 1]}\n",
      "2:22: unknown key 'window.z', expected x, y or axes" },
    { RATES "window: {x: [-1, 1]}\n",
      "2:9: window.y is missing, expected [lo, hi]" },
    { RATES "window: {x: [1, -1], y: [0, 1]}\n",
      "2:13: window.x: [1, -1] is empty, expected lo < hi" },
    { RATES WINDOW "products: [knees]\n",
      "3:11: products: knees is for a law on a slope, a system has "
      "equilibria, nullclines, field_arrows, manifolds, sensitivities, "
      "trajectories, basins or margin" },
    { RATES "window: {x: [-1, 1], y: [-1, 1], axes: eigen}\n",
      "2:40: window.axes: eigen is for a law on a slope, expected log or "
      "linear" },
    { RATES WINDOW "trajectories: {starts: [{x: 1}]}\n",
      "3:25: trajectories.starts: y: missing, expected a number from -1e300 to "
      "1e300" },
};

static void what_is_wrong_costs_one_line(void **state)
{
    struct scene c;
    struct fault why;

    (void) state;
    for (size_t i = 0; i < COUNT(wrong); i++) {
        const enum status s = scene_of(&c, wrong[i].text, "", &why);
        const char *line = strstr(why.text, "s.yaml:");
        CHECK(s == STATUS_BAD_SCENE, "%s: status %d", wrong[i].text, s);
        CHECK(line && strcmp(line + 7, wrong[i].line) == 0, "%s, expected %s",
              why.text, wrong[i].line);
    }
}

#define TEST(test)                                                             \
    cmocka_unit_test_setup_teardown(test, own_folder_make, own_folder_remove)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(all_of_a_system_is_read),
        TEST(one_text_says_all),
        TEST(what_is_wrong_costs_one_line),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
