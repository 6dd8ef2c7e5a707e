/* Numbers of scenes and command lines. */
#include "number.h"

#include <math.h>
#include <string.h>

#include "check.h"
#include "comma_locale.h"

#define COUNT(array) (sizeof(array) / sizeof *(array))

static void is_read_as(const char *text, double wanted)
{
    double x = -77.0;

    CHECK(number_read(text, &x) && x == wanted, "'%s': %.17g", text, x);
}

static void decimal_numbers_are_read(void **state)
{
    (void) state;
    is_read_as("0", 0.0);
    is_read_as("-0", 0.0);
    is_read_as("42", 42.0);
    is_read_as("007", 7.0);
    is_read_as("+2.5", 2.5);
    is_read_as("-1.5e-3", -1.5e-3);
    is_read_as("1E5", 1e5);
    is_read_as("1e+05", 1e5);
    is_read_as(".5", 0.5);
    is_read_as("5.", 5.0);
    is_read_as("5.e1", 50.0);
    is_read_as("1.7976931348623157e308", 0x1.fffffffffffffp1023);
    is_read_as("4.9e-324", 0x1p-1074);
    is_read_as("1e-400", 0.0);
    is_read_as("inf", (double) INFINITY);
    is_read_as(".inf", (double) INFINITY);
}

/* 1 + 2^-53 is half way between two doubles. */
static void the_nearest_double_is_found_however_long_the_number(void **state)
{
    char text[800];

    (void) state;
    is_read_as("1.00000000000000011102230246251565404236316680908203125", 1.0);
    snprintf(text, sizeof text, "%s%0600d1",
             "1.00000000000000011102230246251565404236316680908203125", 0);
    is_read_as(text, 1.0 + 0x1p-52);
}

static void every_double_comes_back_from_17_digits(void **state)
{
    uint64_t seed = check_seed();

    (void) state;
    for (int i = 0; i < 20000; i++) {
        const uint64_t bits = check_bits(&seed);
        double x;
        char text[40];
        memcpy(&x, &bits, sizeof x);
        snprintf(text, sizeof text, "%.17g", x);
        if (isfinite(x))
            is_read_as(text, x);
    }
}

static const char *const no_number[] = {
    "",          " ",     " 1",   "1 ",    "1 2",   "nan",   ".nan",
    "NaN",       "Inf",   "-inf", "+inf",  "infin", "-.inf", "1e400",
    "-1e400",    "0x1p3", "0x10", "1_000", "1,5",   "1.5.2", "1e",
    "e5",        "1e5.0", "--1",  "+",     ".",     "1-2",   "1:30",
    "1/2",       "9.8 m", "1d5",  "abc",   "1\n",   "1e5e5", "\xd9\xa1",
    "1\xc2\xa0", "true",  "~",    "()",    "1f",
};

static void anything_else_is_no_number_and_leaves_the_value(void **state)
{
    char digits[1200];

    (void) state;
    for (size_t i = 0; i < COUNT(no_number); i++) {
        double x = -77.0;
        CHECK(!number_read(no_number[i], &x), "'%s'", no_number[i]);
        CHECK(x == -77.0, "'%s': %g", no_number[i], x);
    }
    double x = -77.0;
    memset(digits, '0', sizeof digits);
    digits[sizeof digits - 1] = '\0';
    assert_false(number_read(digits, &x));
    assert_true(x == -77.0);
}

static void a_decimal_comma_of_the_locale_changes_nothing(void **state)
{
    double x = -77.0;

    (void) state;
    comma_locale_use(true);
    is_read_as("0.34", 0.34);
    is_read_as("1.5e-3", 1.5e-3);
    is_read_as(".5", 0.5);
    is_read_as("12", 12.0);
    is_read_as("1.5e-300", 1.5e-300);
    assert_string_equal(number_shortest(1.5e-300).text, "1.5e-300");
    assert_false(number_read("0,34", &x));
    assert_false(number_read("1.5.2", &x));
    comma_locale_use(false);
    assert_true(x == -77.0);
}

static void whole_numbers_are_read_up_to_64_bits(void **state)
{
    uint64_t n = 77;

    (void) state;
    assert_true(number_read_whole("0", &n) && n == 0);
    assert_true(number_read_whole("0012", &n) && n == 12);
    assert_true(number_read_whole("18446744073709551615", &n));
    assert_true(n == UINT64_MAX);
}

static void anything_else_is_no_whole_number(void **state)
{
    static const char *const text[] = {
        "",
        " 1",
        "1 ",
        "-1",
        "+1",
        "1.0",
        "1e3",
        "0x10",
        "1_000",
        "inf",
        "a",
        "1,0",
        "18446744073709551616",
        "99999999999999999999999999999999",
    };

    (void) state;
    for (size_t i = 0; i < COUNT(text); i++) {
        uint64_t n = 77;
        CHECK(!number_read_whole(text[i], &n) && n == 77, "'%s'", text[i]);
    }
}

/* ---- written ------------------------------------------------------------- */

static void is_written_as(double x, const char *wanted)
{
    CHECK(strcmp(number_shortest(x).text, wanted) == 0, "%.17g: %s", x,
          number_shortest(x).text);
}

static void the_shortest_decimal_is_written(void **state)
{
    (void) state;
    is_written_as(0.34, "0.34");
    is_written_as(0.1 + 0.2, "0.30000000000000004");
    is_written_as(-1000.0, "-1000");
    is_written_as(1e300, "1e+300");
    is_written_as(0x1p-1074, "4.94065645841247e-324");
    is_written_as(-0.0, "-0");
    comma_locale_use(true);
    is_written_as(0.34, "0.34");
    comma_locale_use(false);
}

static void what_is_written_reads_back(void **state)
{
    uint64_t seed = check_seed();

    (void) state;
    for (int i = 0; i < 20000; i++) {
        const double x = pow(10.0, check_uniform(&seed, -300.0, 300.0));
        double read = 0.0;
        CHECK(number_read(number_shortest(x).text, &read) && read == x,
              "%.17g: %s", x, number_shortest(x).text);
    }
}

static void has_bar(double x, double error, const char *value, const char *bar)
{
    const struct number_bar b = number_with_bar(x, error);

    CHECK(strcmp(b.value.text, value) == 0 && strcmp(b.error.text, bar) == 0,
          "%.17g %.17g: %s +- %s", x, error, b.value.text, b.error.text);
}

static void a_bar_tells_how_many_digits_there_are(void **state)
{
    (void) state;
    has_bar(2832.2233588543, 2.1e-10, "2832.2233588543", "2.1e-10");
    has_bar(2832.2233588543, 2.2e-2, "2832.223", "2.3e-02");
    has_bar(2832.2233588543, 1e4, "3000", "1.1e+04");
    has_bar(0.34, 0.0, "0.34", "0.0e+00");
    has_bar(2.0 / 3.0, 1e-18, "0.6666666666666666", "1.0e-18");
}

/* |shown - truth| <= |shown - value| + error <= bar */
static void a_bar_holds_what_was_cut_off(void **state)
{
    uint64_t seed = check_seed();

    (void) state;
    for (int i = 0; i < 20000; i++) {
        const double x = pow(10.0, check_uniform(&seed, -30.0, 30.0)),
                     error = x * pow(10.0, check_uniform(&seed, -17.0, 2.0));
        const struct number_bar b = number_with_bar(x, error);
        double shown = 0.0, bar = 0.0;
        CHECK(number_read(b.value.text, &shown) &&
                  number_read(b.error.text, &bar),
              "%s +- %s", b.value.text, b.error.text);
        CHECK(fabs(shown - x) + error <= bar && bar <= 1.2 * error,
              "%.17g %.17g: %s +- %s", x, error, b.value.text, b.error.text);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(decimal_numbers_are_read),
        cmocka_unit_test(the_nearest_double_is_found_however_long_the_number),
        cmocka_unit_test(every_double_comes_back_from_17_digits),
        cmocka_unit_test(anything_else_is_no_number_and_leaves_the_value),
        cmocka_unit_test(a_decimal_comma_of_the_locale_changes_nothing),
        cmocka_unit_test(whole_numbers_are_read_up_to_64_bits),
        cmocka_unit_test(anything_else_is_no_whole_number),
        cmocka_unit_test(the_shortest_decimal_is_written),
        cmocka_unit_test(what_is_written_reads_back),
        cmocka_unit_test(a_bar_tells_how_many_digits_there_are),
        cmocka_unit_test(a_bar_holds_what_was_cut_off),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
