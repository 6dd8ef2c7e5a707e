/* strtod reads numbers correctly rounded, but with the locale's decimal
 * point: it is given that one.  (newlocale could fail.) */
#include "number.h"

#include <errno.h>
#include <float.h>
#include <locale.h>
#include <math.h>
#include <mpfr.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "decimal.h"

/* No double has more digits that matter: 767 and an exponent. */
enum { LETTERS = 800 };

/* As strtod wants it, of at most LETTERS. */
struct local {
    char text[LETTERS + 16];
};

static struct local local_of(const char *text)
{
    struct local local;
    const size_t size = strlen(text), whole = strcspn(text, ".");
    const bool has_point = whole < size;
    char *at = mempcpy(local.text, text, whole);

    if (has_point)
        at = stpncpy(at, localeconv()->decimal_point, 8);
    strcpy(at, text + whole + has_point);
    return local;
}

bool number_read(const char *text, double *value)
{
    const size_t size = strlen(text);
    char *end;

    if (strcmp(text, "inf") == 0 || strcmp(text, ".inf") == 0) {
        *value = (double) INFINITY;
        return true;
    }
    if (decimal_read(text, value))
        return true;
    if (size == 0 || size > LETTERS || strspn(text, "+-.0123456789eE") != size)
        return false;
    const struct local local = local_of(text);
    const double x = strtod(local.text, &end);
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

    if (!decimal_write(value, digits, shown.text)) {
        snprintf(shown.text, sizeof shown.text, "%.*g", digits, value);
        put_point(&shown);
    }
    return shown;
}

static double read_back(struct number_text shown, double value)
{
    double read = value;

    number_read(shown.text, &read);
    return read;
}

static double rounded(int digits, double value)
{
    double read;

    return decimal_round(value, digits, &read)
               ? read
               : read_back(number_digits(digits, value), value);
}

/* The fewest digits, `digits` or more, that move it by at most `most`; *moved:
 * by how much.  What d digits hold, d + 1 hold no worse: by bisection.  Up to
 * 15 digits are written without an exponent where %g of 15 does. */
static struct number_text number_within(double value, double most, int digits,
                                        double *moved)
{
    double read = value;
    int enough = DBL_DECIMAL_DIG;

    *moved = 0.0;
    while (digits < enough) {
        const int middle = (digits + enough) / 2;
        const double less = rounded(middle, value), off = fabs(less - value);

        if (off > most) {
            digits = middle + 1;
        } else {
            read = less;
            *moved = off;
            enough = middle;
        }
    }
    return enough < DBL_DIG ? number_digits(DBL_DIG, read)
                            : number_digits(enough, value);
}

struct number_text number_shortest(double value)
{
    double moved;

    return number_within(value, 0.0, DBL_DIG, &moved);
}

long double number_decimal(double value)
{
    return strtold(local_of(number_shortest(value).text).text, NULL);
}

struct number_text number_outward(double value, bool up)
{
    struct number_text shown;
    MPFR_DECL_INIT(exact, DBL_MANT_DIG);

    mpfr_set_d(exact, value, MPFR_RNDN);
    mpfr_snprintf(shown.text, sizeof shown.text, "%.17R*g",
                  up ? MPFR_RNDU : MPFR_RNDD, exact);
    put_point(&shown);
    return shown;
}

static struct number_text number_leading(double error)
{
    struct number_text shown;

    snprintf(shown.text, sizeof shown.text, "%.1e", error);
    put_point(&shown);
    return shown;
}

/* Two digits, not below: the nearest, or where that is less, n of its last
 * digit, n + 1 of them. */
static struct number_text number_above(double error)
{
    const struct number_text near = number_leading(error);
    const double read = read_back(near, error);
    const int n = 10 * (near.text[0] - '0') + near.text[2] - '0';

    return read < error ? number_leading(read + read / n) : near;
}

struct number_bar number_with_bar(double value, double error)
{
    struct number_bar shown;
    double moved;

    shown.value = number_within(value, error / 20.0, 1, &moved);
    shown.error = number_above(error + moved);
    return shown;
}
