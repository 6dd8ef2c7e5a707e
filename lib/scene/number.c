/* strtod reads numbers correctly rounded, but with the locale's decimal
 * point: it is given that one.  (newlocale could fail.) */
#include "number.h"

#include <errno.h>
#include <float.h>
#include <locale.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* No double has more digits that matter: 767 and an exponent. */
enum { LETTERS = 800 };

bool number_read(const char *text, double *value)
{
    char copy[LETTERS + 16], *end;
    const size_t size = strlen(text);
    const size_t whole = strcspn(text, ".");

    if (strcmp(text, "inf") == 0 || strcmp(text, ".inf") == 0) {
        *value = (double) INFINITY;
        return true;
    }
    if (size == 0 || size > LETTERS || strspn(text, "+-.0123456789eE") != size)
        return false;
    const bool has_point = whole < size;
    snprintf(copy, sizeof copy, "%.*s%.8s%s", (int) whole, text,
             has_point ? localeconv()->decimal_point : "",
             text + whole + has_point);
    const double x = strtod(copy, &end);
    if (*end != '\0' || !isfinite(x))
        return false;
    *value = x;
    return true;
}

bool number_read_whole(const char *text, uint64_t *value)
{
    const size_t size = strlen(text);

    if (size == 0 || strspn(text, "0123456789") != size)
        return false;
    errno = 0;
    const unsigned long long n = strtoull(text, NULL, 10);
    if (errno != 0 || n > UINT64_MAX)
        return false;
    *value = n;
    return true;
}

void number_decimal(double value, char text[NUMBER_DECIMAL])
{
    int digits = DBL_DIG - 1;

    do
        snprintf(text, NUMBER_DECIMAL, "%.*g", ++digits, value);
    while (strtod(text, NULL) != value && digits < DBL_DECIMAL_DIG);
    char *point = strchr(text, localeconv()->decimal_point[0]);
    if (point)
        *point = '.';
}
