/*
 * decimal.c -- a decimal is m 10^-p of integers m < 10^17 < 2^57 and |p| <= 44,
 * and 10^|p| is exact in 113 bits.  m and the value are each other's product
 * or quotient with it, rounded once, by 2^-113 of itself: where that is not as
 * near to a tie, what it is rounded to is what the exact number is.
 */
#include "decimal.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

#include "quad.h"

enum { DIGITS = 17, PLACES = 44, HALF = 22 };

static const double ten[HALF + 1] = { 1e0,  1e1,  1e2,  1e3,  1e4,  1e5,
                                      1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                      1e12, 1e13, 1e14, 1e15, 1e16, 1e17,
                                      1e18, 1e19, 1e20, 1e21, 1e22 };

/* u 10^p, |p| <= PLACES */
static quad moved(quad u, int p)
{
    const int n = p < 0 ? -p : p;
    const quad by = n > HALF ? (quad) ten[HALF] * ten[n - HALF] : ten[n];

    return p < 0 ? u / by : u * by;
}

/* ---- read ---------------------------------------------------------------- */

/* Digits from *at on, into *m while it has at most 17; how many. */
static int read_digits(const char **at, uint64_t *m)
{
    int n = 0;

    for (; **at >= '0' && **at <= '9'; (*at)++, n++)
        *m = *m < (uint64_t) ten[DIGITS - 1] ? 10 * *m + (uint64_t) (**at - '0')
                                             : UINT64_MAX;
    return n;
}

/* Doubles end 60 bits before the last of 113: a half of their last digit. */
static bool is_tie(quad u)
{
    uint64_t low;

    memcpy(&low, &u, sizeof low);
    return (low & (((uint64_t) 1 << 60) - 1)) == (uint64_t) 1 << 59;
}

/* m 10^-places */
static bool double_of(uint64_t m, int places, double *value)
{
    const quad exact = moved((quad) m, -places);

    if (is_tie(exact))
        return false;
    *value = (double) exact;
    return true;
}

bool decimal_read(const char *text, double *value)
{
    const bool minus = *text == '-';
    uint64_t m = 0, power = 0;
    int places = 0;

    text += minus || *text == '+';
    int n = read_digits(&text, &m);
    if (*text == '.') {
        text++;
        places = read_digits(&text, &m);
        n += places;
    }
    if (n > 0 && (*text == 'e' || *text == 'E')) {
        const bool less = *++text == '-';
        text += less || *text == '+';
        n = read_digits(&text, &power);
        if (power > 2 * PLACES)
            return false;
        places += less ? (int) power : -(int) power;
    }
    if (n == 0 || *text != '\0' || m == UINT64_MAX || m == 0 ||
        places > PLACES || places < -PLACES)
        return false;
    if (!double_of(m, places, value))
        return false;
    *value = minus ? -*value : *value;
    return true;
}

/* ---- written ------------------------------------------------------------- */

/* |value| as m 10^-places, m of so many digits. */
static bool whole_of(double value, int digits, uint64_t *m, int *places)
{
    if (!isnormal(value))
        return false;
    *places = digits - 1 - (int) floor(log10(fabs(value)));
    if (*places > PLACES || *places < -PLACES)
        return false;
    const quad exact = moved((quad) fabs(value), *places);
    *m = (uint64_t) exact;
    const double rest = (double) (exact - (quad) *m);
    *m += rest > 0.5;
    return fabs(rest - 0.5) > 1e-12 && *m < (uint64_t) ten[digits] &&
           *m >= (uint64_t) ten[digits - 1];
}

bool decimal_round(double value, int digits, double *rounded)
{
    uint64_t m;
    int places;

    if (!whole_of(value, digits, &m, &places) || !double_of(m, places, rounded))
        return false;
    *rounded = copysign(*rounded, value);
    return true;
}

/* d[0].d[1]..d[n - 1] 10^power without an exponent, or with one. */
static char *put_plain(char *at, const char *d, int n, int power)
{
    if (power < 0) {
        *at++ = '0';
        *at++ = '.';
        at = memset(at, '0', (size_t) (-power - 1));
        return mempcpy(at - power - 1, d, (size_t) n);
    }
    for (int i = 0; i < n || i <= power; i++) {
        if (i == power + 1)
            *at++ = '.';
        *at++ = i < n ? d[i] : '0';
    }
    return at;
}

static char *put_power(char *at, const char *d, int n, int power)
{
    const int size = power < 0 ? -power : power;

    at = put_plain(at, d, n, 0);
    *at++ = 'e';
    *at++ = power < 0 ? '-' : '+';
    *at++ = (char) ('0' + size / 10);
    *at++ = (char) ('0' + size % 10);
    return at;
}

bool decimal_write(double value, int digits, char *text)
{
    char d[DIGITS];
    uint64_t m;
    int n = digits, places;

    if (!whole_of(value, digits, &m, &places))
        return false;
    for (int i = digits; i-- > 0; m /= 10)
        d[i] = (char) ('0' + m % 10);
    while (n > 1 && d[n - 1] == '0')
        n--;
    const int power = digits - 1 - places;
    if (value < 0)
        *text++ = '-';
    *(power < -4 || power >= digits ? put_power : put_plain)(text, d, n,
                                                             power) = '\0';
    return true;
}
