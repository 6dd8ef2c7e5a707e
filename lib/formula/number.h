/* number.h -- numbers as users write and read them: decimal, with a point,
 * whatever the locale. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

/* A decimal number such as -1.5e-3, rounded to the nearest double, or "inf"
 * (".inf" in YAML).  False, *value untouched, for anything else: hexadecimals,
 * NaN, numbers beyond a double, blanks or letters before or after. */
bool number_read(const char *text, double *value);

/* Digits only, below 2^64.  False, *value untouched, for anything else. */
bool number_read_whole(const char *text, uint64_t *value);

struct number_text {
    char text[26];
};

/* The shortest decimal that reads back as the same double: 0.34, 1e+300. */
struct number_text number_shortest(double value);

/* That decimal itself, to 64 bits: what was typed, where it was at most 15
 * digits. */
long double number_decimal(double value);

/* With 17 digits, rounded up or down: on that side of the value, or at it. */
struct number_text number_outward(double value, bool up);

/* A value with the bar |value - truth| <= error, as "2832.22335885 +- 2.2e-10":
 * the fewest digits that move it by at most error/20, and the bar rounded up,
 * what was moved included.  With as many digits as there are where the bar is
 * below a rounding of the value. */
struct number_bar {
    struct number_text value, error;
};
struct number_bar number_with_bar(double value, double error);
