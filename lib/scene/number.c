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

/* ---- written ------------------------------------------------------------- */

static void put_point(struct number_text *shown)
{
    char *point = strchr(shown->text, localeconv()->decimal_point[0]);

    if (point)
        *point = '.';
}

static struct number_text number_digits(int digits, double value)
{
    struct number_text shown;

    snprintf(shown.text, sizeof shown.text, "%.*g", digits, value);
    put_point(&shown);
    return shown;
}

/* The fewest digits, from `digits` on, that move it by at most `most`; *moved:
 * by how much.  Up to 15 digits are written without an exponent where %g of 15
 * does. */
static struct number_text number_within(double value, double most, int digits,
                                        double *moved)
{
    for (;; digits++) {
        struct number_text shown = number_digits(digits, value);
        double read = value;
        number_read(shown.text, &read);
        *moved = fabs(read - value);
        if (!(*moved > most) || digits >= DBL_DECIMAL_DIG)
            return digits < DBL_DIG ? number_digits(DBL_DIG, read) : shown;
    }
}

struct number_text number_shortest(double value)
{
    double moved;

    return number_within(value, 0.0, DBL_DIG, &moved);
}

/* Two digits, not below. */
static struct number_text number_above(double error)
{
    double up = error, read = 0.0;
    struct number_text shown;

    for (;; up *= 1.01) {
        snprintf(shown.text, sizeof shown.text, "%.1e", up);
        put_point(&shown);
        if (!number_read(shown.text, &read) || read >= error)
            return shown;
    }
}

struct number_bar number_with_bar(double value, double error)
{
    struct number_bar shown;
    double moved;

    shown.value = number_within(value, error / 20.0, 1, &moved);
    shown.error = number_above(error + moved);
    return shown;
}
