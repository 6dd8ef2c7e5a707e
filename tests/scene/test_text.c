/* Texts made fit for one line. */
#include "text.h"

#include <string.h>

#include "check.h"

static void shows_as(const char *text, const char *wanted)
{
    char out[200];

    text_show(text, out, sizeof out);
    assert_string_equal(out, wanted);
    text_show_end(text, out, sizeof out);
    assert_string_equal(out, wanted);
}

static void printable_text_is_shown_as_it_is(void **state)
{
    (void) state;
    shows_as("", "");
    shows_as("slope.alpha = 0.34 ~\\'\"", "slope.alpha = 0.34 ~\\'\"");
    shows_as("\xc3\xa9\xe2\x82\xac\xf0\x9f\x98\x80",
             "\xc3\xa9\xe2\x82\xac\xf0\x9f\x98\x80");
}

static void controls_and_line_ends_are_escaped(void **state)
{
    (void) state;
    shows_as("a\nb\r\tc\x1b[31m\x7f", "a\\x0ab\\x0d\\x09c\\x1b[31m\\x7f");
    shows_as("\xc2\x80\xc2\x9f\xc2\xa0", "\\xc2\\x80\\xc2\\x9f\xc2\xa0");
    shows_as("\xe2\x80\xa8\xe2\x80\xa9", "\\xe2\\x80\\xa8\\xe2\\x80\\xa9");
}

static void marks_that_turn_the_text_around_are_escaped(void **state)
{
    (void) state;
    shows_as("\xe2\x80\xae", "\\xe2\\x80\\xae"); /* right to left */
    shows_as("\xe2\x81\xa6", "\\xe2\\x81\\xa6"); /* isolate */
    shows_as("\xd8\x9c", "\\xd8\\x9c");
    shows_as("\xef\xbb\xbf", "\\xef\\xbb\\xbf");
}

static void bytes_that_are_not_utf8_are_escaped(void **state)
{
    (void) state;
    shows_as("\xff\xfe", "\\xff\\xfe");
    shows_as("\x80", "\\x80");
    shows_as("\xc3", "\\xc3");                            /* cut short */
    shows_as("\xe2\x82", "\\xe2\\x82");                   /* cut short */
    shows_as("\xc3\x28", "\\xc3(");                       /* no second byte */
    shows_as("\xc0\xaf", "\\xc0\\xaf");                   /* too long for '/' */
    shows_as("\xed\xa0\x80", "\\xed\\xa0\\x80");          /* a surrogate */
    shows_as("\xf4\x90\x80\x80", "\\xf4\\x90\\x80\\x80"); /* > 10ffff */
}

static void a_long_text_is_cut_between_characters(void **state)
{
    char out[10];

    (void) state;
    text_show("123456789", out, sizeof out);
    assert_string_equal(out, "123456789");
    text_show("1234567890", out, sizeof out);
    assert_string_equal(out, "123456...");
    text_show("12345\xc3\xa9"
              "7890",
              out, sizeof out);
    assert_string_equal(out, "12345...");
    text_show("12\nabcdefgh", out, sizeof out);
    assert_string_equal(out, "12\\x0a...");
}

static void the_end_of_a_long_text_may_stay_instead(void **state)
{
    char out[10];

    (void) state;
    text_show_end("123456789", out, sizeof out);
    assert_string_equal(out, "123456789");
    text_show_end("1234567890", out, sizeof out);
    assert_string_equal(out, "...567890");
    text_show_end("1234\xc3\xa9"
                  "67890",
                  out, sizeof out);
    assert_string_equal(out, "...67890");
}

/* ---- any bytes ----------------------------------------------------------- */

/* Bytes of all kinds, more of those that matter to UTF-8; ends in a zero. */
static void random_text(uint64_t *seed, char *text, size_t size)
{
    static const char *const part[] = {
        "\xc3\xa9", "\xe2\x82\xac",     "\n",
        "a",        "\xf0\x9f\x98\x80", "\xe2\x80\xae"
    };
    size_t used = 0;

    while (used + 5 < size) {
        const uint64_t r = check_bits(seed);
        if (r % 2)
            text[used++] = (char) (r >> 8 & 0xff ? r >> 8 & 0xff : 1);
        else
            used += (size_t) sprintf(text + used, "%s", part[r / 2 % 6]);
    }
    text[used] = '\0';
}

/* What is shown may be shown again: it is all printable, and whole. */
static void fits(const char *out, size_t size)
{
    char again[200];

    CHECK(strlen(out) < size, "%zu of %zu", strlen(out), size);
    text_show(out, again, sizeof again);
    CHECK(strcmp(out, again) == 0, "'%s'", again);
}

static void whatever_the_bytes_one_printable_line_fits(void **state)
{
    uint64_t seed = check_seed();

    (void) state;
    for (int i = 0; i < 3000; i++) {
        char text[64], out[200];
        const size_t size = 5 + check_bits(&seed) % 100;
        random_text(&seed, text, 8 + check_bits(&seed) % 56);
        memset(out, '#', sizeof out);
        text_show(text, out, size);
        fits(out, size);
        text_show_end(text, out, size);
        fits(out, size);
    }
}

/* ---- copies and lists ---------------------------------------------------- */

static void a_copy_ends_in_a_zero(void **state)
{
    char *copy = text_copy("abcdef", 3);

    (void) state;
    assert_string_equal(copy, "abc");
    free(copy);
    copy = text_copy("", 0);
    assert_string_equal(copy, "");
    free(copy);
}

static void a_word_in_a_message_is_cut_at_63_bytes(void **state)
{
    char word[100];

    (void) state;
    memset(word, 'w', sizeof word);
    word[99] = '\0';
    const struct text_shown shown = text_shown(word);
    assert_int_equal(strlen(shown.text), 63);
    assert_string_equal(shown.text + 60, "...");
}

static void a_list_reads_like_a_sentence(void **state)
{
    static const char *const words[] = { "a", "bc", "def", NULL };
    char out[20];

    (void) state;
    text_list(words + 3, out, sizeof out);
    assert_string_equal(out, "");
    text_list(words + 2, out, sizeof out);
    assert_string_equal(out, "def");
    text_list(words + 1, out, sizeof out);
    assert_string_equal(out, "bc or def");
    text_list(words, out, sizeof out);
    assert_string_equal(out, "a, bc or def");
    text_list(words, out, 6);
    assert_string_equal(out, "a, bc");
    text_list(words, out, 1);
    assert_string_equal(out, "");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(printable_text_is_shown_as_it_is),
        cmocka_unit_test(controls_and_line_ends_are_escaped),
        cmocka_unit_test(marks_that_turn_the_text_around_are_escaped),
        cmocka_unit_test(bytes_that_are_not_utf8_are_escaped),
        cmocka_unit_test(a_long_text_is_cut_between_characters),
        cmocka_unit_test(the_end_of_a_long_text_may_stay_instead),
        cmocka_unit_test(whatever_the_bytes_one_printable_line_fits),
        cmocka_unit_test(a_copy_ends_in_a_zero),
        cmocka_unit_test(a_word_in_a_message_is_cut_at_63_bytes),
        cmocka_unit_test(a_list_reads_like_a_sentence),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
