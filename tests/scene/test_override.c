/* --set KEY=VALUE, on the tree of a scene. */
#include "override.h"

#include <string.h>

#include "check.h"
#include "document.h"
#include "fault_alloc.h"

#define COUNT(array) (sizeof(array) / sizeof *(array))

/* The tree in one line, e.g. "{slope:{alpha:0.3},window:{v:[1,2]}}". */
static void describe(const struct node *n, char *out)
{
    const bool list = n->kind == NODE_LIST;

    if (n->kind == NODE_SCALAR) {
        strcat(out, n->text);
        return;
    }
    strcat(out, list ? "[" : "{");
    for (size_t i = 0; i < n->count; i++) {
        strcat(out, i ? "," : "");
        if (!list)
            strcat(strcat(out, n->child[i]->key), ":");
        describe(n->child[i], out);
    }
    strcat(out, list ? "]" : "}");
}

static struct node *tree(const char *text)
{
    struct node *root = NULL;
    struct fault why;

    assert_int_equal(document_read(text, strlen(text), "s.yaml", &root, &why),
                     STATUS_OK);
    return root;
}

static void becomes(const char *text, const char *set, const char *wanted)
{
    struct node *root = tree(text);
    struct fault why;
    char found[512] = "";

    const enum status s = override_apply(root, set, &why);
    CHECK(s == STATUS_OK, "%s", why.text);
    describe(root, found);
    assert_string_equal(found, wanted);
    node_free(root);
}

static void a_key_is_put_where_its_path_says(void **state)
{
    (void) state;
    becomes("", "title=a=b: c", "{title:{a=b:c}}");
    becomes("", "title='a=b'", "{title:a=b}");
    becomes("", "slope.alpha=0.3", "{slope:{alpha:0.3}}");
    becomes("", "window.v=[1e-3, 1e3]", "{window:{v:[1e-3,1e3]}}");
    becomes("", "trajectories.until.time=2", "{trajectories:{until:{time:2}}}");
    becomes("window: {axes: log}", "window.v=[1, 2]",
            "{window:{axes:log,v:[1,2]}}");
    becomes("trajectories: {until: {slip: 3}}", "trajectories.until.time=2",
            "{trajectories:{until:{slip:3,time:2}}}");
}

static void a_section_with_nothing_in_it_is_filled(void **state)
{
    (void) state;
    becomes("slope:\ntitle: x", "slope.alpha=0.3",
            "{slope:{alpha:0.3},title:x}");
    becomes("trajectories: {until: }", "trajectories.until.time=2",
            "{trajectories:{until:{time:2}}}");
}

static void a_value_takes_the_place_of_another(void **state)
{
    (void) state;
    becomes("slope: {alpha: 0.3}", "slope.alpha=0.4", "{slope:{alpha:0.4}}");
    becomes("window: {v: [1, 2], axes: log}",
            "window.v=", "{window:{axes:log,v:}}");
    becomes("slope: {alpha: 0.3}", "slope={alpha_deg: 20}",
            "{slope:{alpha_deg:20}}");
    becomes("slope: 0.3", "slope={alpha_deg: 20}", "{slope:{alpha_deg:20}}");
    becomes("material: {a: 1, b: 2}", "material={}", "{material:{}}");
}

static void what_a_key_excludes_is_taken_back(void **state)
{
    (void) state;
    becomes("slope: {alpha_deg: 20}", "slope.alpha=0.3", "{slope:{alpha:0.3}}");
    becomes("slope: {alpha: 0.3}", "slope.tan_alpha=1",
            "{slope:{tan_alpha:1}}");
    becomes("law: {theta: psi, psi_ss: minus_log, timescale: slip, "
            "kinetics: sinh, friction: log}",
            "law.preset=ruina", "{law:{friction:log,preset:ruina}}");
    becomes("law: {preset: ruina, friction: log}", "law.kinetics=sinh",
            "{law:{friction:log,kinetics:sinh}}");
    becomes("trajectories: {sample: {log_time: 9}, spread: 3}",
            "trajectories.sample.linear_slip=5",
            "{trajectories:{sample:{linear_slip:5},spread:3}}");
}

/* ---- what is refused ----------------------------------------------------- */

static void refused(const char *text, const char *set, const char *line)
{
    struct node *root = tree(text);
    struct fault why;

    assert_int_equal(override_apply(root, set, &why), STATUS_BAD_SCENE);
    assert_string_equal(why.text, line);
    node_free(root);
}

static void an_override_has_a_known_key_and_a_value_on_one_line(void **state)
{
    (void) state;
    refused("", "slope.alpha", "--set slope.alpha: no '=', expected KEY=VALUE");
    refused("", "", "--set : no '=', expected KEY=VALUE");
    refused("", "title=a\nb",
            "--set title=a\\x0ab: a line end, expected "
            "KEY=VALUE in a line");
    refused("", "title=a\r",
            "--set title=a\\x0d: a line end, expected "
            "KEY=VALUE in a line");
    refused("", "slope.alpah=0.3",
            "--set slope.alpah=0.3: unknown key 'slope.alpah', expected "
            "alpha, alpha_deg or tan_alpha (did you mean slope.alpha?)");
    refused("", "window.tan_alpha=1",
            "--set window.tan_alpha=1: unknown key 'window.tan_alpha', "
            "expected v, psi, phi or axes (did you mean slope.tan_alpha?)");
    refused("", "slope.alpha.x=1",
            "--set slope.alpha.x=1: unknown key 'slope.alpha.x', expected "
            "alpha, alpha_deg or tan_alpha (did you mean slope.alpha?)");
    refused("", "slope.angle=20",
            "--set slope.angle=20: unknown key 'slope.angle', expected "
            "alpha, alpha_deg or tan_alpha (did you mean slope.alpha_deg?)");
    refused("", "slope.=1",
            "--set slope.=1: unknown key 'slope.', expected "
            "alpha, alpha_deg or tan_alpha");
}

static void a_value_is_yaml(void **state)
{
    (void) state;
    refused("", "window.v=[1, 2",
            "--set window.v=[1, 2: did not find expected ',' or ']' while "
            "parsing a flow sequence, expected YAML: 'key: value', indented "
            "by spaces, brackets and quotes closed");
    refused("", "title=&a x",
            "--set title=&a x: anchors, aliases and tags "
            "are not allowed, expected a value written out");
    refused("", "title=\xff",
            "--set title=\\xff: byte 0xff at offset 0 of "
            "the value: invalid leading UTF-8 octet, "
            "expected text in UTF-8");
    refused("", "slope={alpha: 1, alpha: 2}",
            "--set slope={alpha: 1, alpha: 2}: key 'alpha' is given twice, "
            "expected it once");
}

/* Here the file is to blame. */
static void keys_cannot_be_put_into_a_value(void **state)
{
    (void) state;
    refused("slope: 0.3", "slope.alpha=0.4",
            "s.yaml:1:8: slope: '0.3' is not allowed, expected a map of keys, "
            "alpha, alpha_deg or tan_alpha, as in 'slope: {alpha: ...}'");
    refused("trajectories: {until: [1]}", "trajectories.until.time=1",
            "s.yaml:1:23: trajectories.until: a list is not allowed, expected "
            "a map of keys, time or slip, as in 'until: {time: ...}'");
    refused("law: aging", "law.preset=ruina",
            "s.yaml:1:6: law: 'aging' is not allowed, expected a map of keys, "
            "preset, theta, psi_ss, timescale, kinetics, T, K, rate, mu, state "
            "or friction, as in 'law: {preset: ...}'");
}

static void a_long_override_is_cut_in_the_message(void **state)
{
    char set[2000];
    struct node *root = tree("");
    struct fault why;

    (void) state;
    memset(set, 'x', sizeof set);
    set[1999] = '\0';
    set[1000] = '=';
    assert_int_equal(override_apply(root, set, &why), STATUS_BAD_SCENE);
    assert_non_null(strstr(why.text, "xxx...: unknown key 'xxxx"));
    assert_non_null(strstr(why.text, "expected title, system, law, material"));
    node_free(root);
}

static void each_allocation_may_fail(void **state)
{
    static const char *const set[] = { "trajectories.until.time=2",
                                       "slope.alpha=0.3",
                                       "window={v: [1, 2]}" };

    (void) state;
    for (size_t i = 0; i < COUNT(set); i++) {
        enum status s = STATUS_NO_MEMORY;
        for (long k = 0; s != STATUS_OK; k++) {
            struct node *root = tree("slope: {alpha_deg: 20}\ntitle: x");
            struct fault why;
            fault_alloc_at(k);
            s = override_apply(root, set[i], &why);
            fault_alloc_at(FAULT_ALLOC_NEVER);
            assert_true(s == STATUS_OK || s == STATUS_NO_MEMORY);
            node_free(root);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_key_is_put_where_its_path_says),
        cmocka_unit_test(a_section_with_nothing_in_it_is_filled),
        cmocka_unit_test(a_value_takes_the_place_of_another),
        cmocka_unit_test(what_a_key_excludes_is_taken_back),
        cmocka_unit_test(an_override_has_a_known_key_and_a_value_on_one_line),
        cmocka_unit_test(a_value_is_yaml),
        cmocka_unit_test(keys_cannot_be_put_into_a_value),
        cmocka_unit_test(a_long_override_is_cut_in_the_message),
        cmocka_unit_test(each_allocation_may_fail),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
