/* A scene and its overrides become one scene, which reads the same. */
#include "merge.h"

#include <string.h>

#include "check.h"
#include "document.h"

static void check_merge(const char *text, const char *overrides,
                        const char *wanted)
{
    char *merged = NULL;
    struct fault why;

    assert_int_equal(scene_merge(text, overrides, &merged, &why), STATUS_OK);
    assert_string_equal(merged, wanted);
    free(merged);
}

static void without_overrides_nothing_changes(void **state)
{
    (void) state;
    check_merge("# why\nlaw: {preset:  ruina}\n", "",
                "# why\nlaw: {preset:  ruina}\n");
    check_merge("", "", "");
    check_merge("[not a scene", "", "[not a scene");
}

static void overrides_replace_what_they_exclude(void **state)
{
    (void) state;
    check_merge("slope: {alpha: 0.3}\n", "slope.alpha_deg=20\n",
                "slope: {alpha_deg: 20}\n");
    check_merge("law: {preset: ruina, friction: log}\n",
                "law.preset=perrin\nlaw.preset=dieterich\n",
                "law: {friction: log, preset: dieterich}\n");
    check_merge("", "law.preset=ruina\ntrajectories.until.time=2\n",
                "law: {preset: ruina}\ntrajectories: {until: {time: 2}}\n");
}

/* "title: 'TITLE'": in single quotes only they need doubling. */
static void write_title(char *out, const char *title)
{
    out += sprintf(out, "title: '");
    for (; *title; title++)
        out += sprintf(out, "%s%c", *title == '\'' ? "'" : "", *title);
    strcpy(out, "'\n");
}

static void texts_come_back_as_they_were(void **state)
{
    static const char *const title[] = {
        "it's",         "a: b",    "# no comment",
        "- x",          "{a",      "\"",
        "\\n",          "%",       "\xc3\xa9\xf0\x9f\x98\x80",
        "0.34",         " blank ", "",
        "&a *b !c | >", "@`",      "[x], y",
        "null",         "a\tb",    "''",
        "---",          "?",
    };

    (void) state;
    for (size_t i = 0; i < sizeof title / sizeof *title; i++) {
        char text[128], *merged = NULL;
        struct node *root = NULL;
        struct fault why;
        write_title(text, title[i]);
        assert_int_equal(scene_merge(text, "gravity=1\n", &merged, &why),
                         STATUS_OK);
        assert_int_equal(
            document_read(merged, strlen(merged), NULL, &root, &why),
            STATUS_OK);
        const char *found = node_find(root, "title")->text;
        CHECK(strcmp(found, title[i]) == 0, "%s, %s", title[i], merged);
        node_free(root);
        free(merged);
    }
}

static void wrong_parts_are_blamed(void **state)
{
    static char untouched;
    char *merged = &untouched;
    struct fault why;

    (void) state;
    assert_int_equal(scene_merge("law: [", "slope.alpha=1", &merged, &why),
                     STATUS_BAD_SCENE);
    CHECK(strstr(why.text, "scene:2:1:"), "%s", why.text);
    assert_int_equal(scene_merge("", "slope.beta=1", &merged, &why),
                     STATUS_BAD_SCENE);
    CHECK(strstr(why.text, "slope.beta"), "%s", why.text);
    assert_ptr_equal(merged, &untouched);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(without_overrides_nothing_changes),
        cmocka_unit_test(overrides_replace_what_they_exclude),
        cmocka_unit_test(texts_come_back_as_they_were),
        cmocka_unit_test(wrong_parts_are_blamed),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
