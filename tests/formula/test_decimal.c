/* The fast way to read and write is the C library's, to the letter. */
#include "decimal.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"

enum { COUNT = 200000 };

/* Of ordinary size; one in seven of few digits, one in seven a tie of them. */
static double drawn(uint64_t *seed, int i)
{
    const double u = check_uniform(seed, -1.0, 1.0);

    return i % 7 == 0   ? round(u * 1e4) / 1e3
           : i % 7 == 1 ? round(u * 1024.0) / 64.0
                        : u * pow(10.0, check_uniform(seed, -26.0, 27.0));
}

static void digits_are_those_of_the_c_library(void **state)
{
    uint64_t seed = check_seed();
    int refused = 0;

    (void) state;
    for (int i = 0; i < COUNT; i++) {
        const double x = drawn(&seed, i);
        const int digits = 1 + (int) (check_bits(&seed) % 17);
        char wanted[40], text[40];
        snprintf(wanted, sizeof wanted, "%.*g", digits, x);
        if (decimal_write(x, digits, text))
            CHECK(strcmp(text, wanted) == 0, "%a: '%s', not '%s'", x, text,
                  wanted);
        else
            refused++;
    }
    CHECK(refused < COUNT / 10, "%d refused", refused);
}

static void decimals_are_read_as_the_c_library_does(void **state)
{
    static const char *const form[] = { "%.*g", "%+.*e", "%.*f", "%.*E" };
    uint64_t seed = check_seed();
    int refused = 0;

    (void) state;
    for (int i = 0; i < COUNT; i++) {
        char text[80];
        double x = NAN;
        snprintf(text, sizeof text, form[check_bits(&seed) % 4],
                 (int) (check_bits(&seed) % 17), drawn(&seed, i));
        if (decimal_read(text, &x))
            CHECK(x == strtod(text, NULL), "'%s': %.17g", text, x);
        else
            refused++;
    }
    CHECK(refused < COUNT / 4, "%d refused", refused);
}

static void what_digits_read_as_is_told_without_them(void **state)
{
    uint64_t seed = check_seed();
    int refused = 0;

    (void) state;
    for (int i = 0; i < COUNT; i++) {
        const double x = drawn(&seed, i);
        const int digits = 1 + (int) (check_bits(&seed) % 17);
        char text[40];
        double y = NAN;
        snprintf(text, sizeof text, "%.*g", digits, x);
        if (decimal_round(x, digits, &y))
            CHECK(y == strtod(text, NULL), "'%s': %.17g", text, y);
        else
            refused++;
    }
    CHECK(refused < COUNT / 4, "%d refused", refused);
}

static void halves_of_a_last_digit_are_refused(void **state)
{
    double x = 7.0;
    char text[40];

    (void) state;
    CHECK(!decimal_read("9007199254740993", &x) && x == 7.0, "%.17g", x);
    CHECK(!decimal_read("12345678901234567", &x), "%.17g", x);
    CHECK(decimal_read("9007199254740992", &x), "refused");
    CHECK(!decimal_write(0.125, 2, text), "'%s'", text);
    CHECK(!decimal_write(-2.5, 1, text), "'%s'", text);
}

static void what_is_no_decimal_is_refused(void **state)
{
    static const char *const text[] = { "",     "-",   ".",   "e5",
                                        "1e",   "1e+", "1.e", "1..2",
                                        "1,5",  " 1",  "1 ",  "0x1",
                                        "1e5x", "inf", "--1", "1e400" };
    double x = 7.0;

    (void) state;
    for (size_t i = 0; i < sizeof text / sizeof *text; i++)
        CHECK(!decimal_read(text[i], &x) && x == 7.0, "'%s': %g", text[i], x);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(digits_are_those_of_the_c_library),
        cmocka_unit_test(decimals_are_read_as_the_c_library_does),
        cmocka_unit_test(what_digits_read_as_is_told_without_them),
        cmocka_unit_test(halves_of_a_last_digit_are_refused),
        cmocka_unit_test(what_is_no_decimal_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
