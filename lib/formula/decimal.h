/* decimal.h -- the decimals of ordinary size, read and written as the C library
 * does it, several times faster.  What is not ordinary is refused: beyond
 * 1e-27 .. 1e44, more than 17 digits, or where 113 bits do not tell how it is
 * rounded. */
#pragma once

#include <stdbool.h>

/* The nearest double of [sign]digits[.digits][e[sign]digits]. */
bool decimal_read(const char *text, double *value);

/* What `digits` digits of it read as. */
bool decimal_round(double value, int digits, double *rounded);

/* As "%.*g" of up to 17 digits, with a point: 24 characters at most. */
bool decimal_write(double value, int digits, char *text);
