/* Texts on their way into gnuplot: quoted, cut, broken into lines, with the
 * marks of a typesetter. */
#include "check.h"

#include <string.h>

#include "label.h"
#include "mark.h"

static struct label_part whole(const char *text)
{
    return (struct label_part){ text, strlen(text) };
}

static void check_line(const char *text, double room, const char *wanted)
{
    char *found = NULL;
    size_t size;
    FILE *out = open_memstream(&found, &size);
    label_write(out, whole(text), room, 1);
    fclose(out);
    assert_string_equal(found, wanted);
    free(found);
}

/* Of a text without marks. */
static void check_label(const char *text, double room, const char *wanted)
{
    char all[256];
    snprintf(all, sizeof all, "%s noenhanced", wanted);
    check_line(text, room, all);
}

static void a_label_is_one_inert_string(void **state)
{
    (void) state;
    check_label("it's", 100, "'it''s'");
    check_label("''a'", 100, "\"'\".\"'\".'a'''");
    check_label("a]]>", 100, "'a]] >'");
    check_label("a\nb\x7f\x1b", 100, "'a b  '");
    check_label("\xcf\x88 \xf0\x9f\x8c\x8d", 100,
                "'\xcf\x88 \xf0\x9f\x8c\x8d'");
    check_label("\xc0\xa7", 100,
                "'?"
                "?'"); /* overlong quote */
    check_label("\xe2\x88", 100,
                "'?"
                "?'"); /* cut short */
    check_label("\xf5\x80\x80\x80", 100,
                "'?"
                "?"
                "?"
                "?'"); /* beyond Unicode */
    check_label("\xef\xbf\xbf", 100,
                "'?"
                "?"
                "?'"); /* not for XML */
    check_label("", 0, "''");
}

static void a_label_without_room_is_cut(void **state)
{
    (void) state;
    check_label("abcdefghij", label_width("abcdefghij"), "'abcdefghij'");
    check_label("abcdefghij", label_width("abcde") + 1, "'abcde\xe2\x80\xa6'");
    check_label("abc", 0, "'\xe2\x80\xa6'");
}

/* Whatever stands beside the marks; those left open are closed. */
static void marks_become_scripts_and_italics(void **state)
{
    (void) state;
    check_line("friction " ITALIC("\xce\xbc") SUB("ss"), 100,
               "'friction {/:Italic \xce\xbc}_{ss}' enhanced");
    check_line(ITALIC("l") SUB(ITALIC("k")), 100,
               "'{/:Italic l}_{{/:Italic k}}' enhanced");
    check_line(SUB("a") "{}^_@&~\\'", 100,
               "'_{a}\\{\\}\\^\\_\\@\\&\\~\\\\''' enhanced");
    check_line("\4\4a" SUPER("2"), 100, "'a^{2}' enhanced");
    check_line("a\2b\3c", 100, "'a_{b^{c}}' enhanced");
    assert_true(label_width(SUB("ss")) < label_width("ss") &&
                label_width(ITALIC("a")) == label_width("a"));
}

static void numbers_have_powers_of_ten(void **state)
{
    (void) state;
    static const struct {
        double x;
        const char *plain;
    } cases[] = {
        { 2.49e-8, "2.49\xc3\x97"
                   "10^\xe2\x88\x92"
                   "8" },
        { -0.0249, "\xe2\x88\x92"
                   "0.0249" },
        { 999996, "1\xc3\x97"
                  "10^6" },
        { 405.11, "405.1" },
        { 59710, "5.971\xc3\x97"
                 "10^4" },
        { 0, "0" },
        { 1e-4, "1\xc3\x97"
                "10^\xe2\x88\x92"
                "4" },
    };
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        char text[64], plain[64];
        mark_number(text, sizeof text, cases[k].x, 4);
        mark_plain(text, plain, sizeof plain);
        assert_string_equal(plain, cases[k].plain);
    }
}

static void a_text_breaks_at_blanks(void **state)
{
    (void) state;
    struct label_part line[3];
    const char *text = "trajectory from the given start";
    const double room = label_width("trajectory from the ");
    assert_int_equal(label_break(text, room, line, 3), 2);
    assert_int_equal(line[0].size, strlen("trajectory from the"));
    assert_string_equal(line[1].text, "given start");
    assert_int_equal(label_break(text, 1, line, 3), 3);
    assert_string_equal(line[2].text, "the given start");
    assert_int_equal(label_break("maximum: v = 6 m/s", 6, line, 3), 2);
    assert_string_equal(line[1].text, "v = 6 m/s");
    assert_int_equal(label_break("law, v = 6 m/s", 5.2, line, 3), 2);
    assert_string_equal(line[1].text, "v = 6 m/s");
    assert_int_equal(label_break("power series, order 30", 9, line, 3), 2);
    assert_string_equal(line[1].text, "order 30");
    assert_int_equal(label_break("law \xe2\x80\x94 preset", 3, line, 3), 2);
    assert_string_equal(line[1].text, "preset");
    assert_int_equal(label_break("word", 1, line, 3), 1);
    assert_int_equal(label_break("", 1, line, 3), 1);
    assert_int_equal(label_break(SUB("a b c"), 1, line, 3), 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_label_is_one_inert_string),
        cmocka_unit_test(a_label_without_room_is_cut),
        cmocka_unit_test(marks_become_scripts_and_italics),
        cmocka_unit_test(numbers_have_powers_of_ten),
        cmocka_unit_test(a_text_breaks_at_blanks),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
