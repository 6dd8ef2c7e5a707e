/*
 * elementary.c -- e^x, ln x and their kin with the same bits on every x86-64.
 *
 * The C library's own ones round differently where the processor multiplies
 * and adds in one rounding.  These take their place when a program is linked:
 * the names are the C library's, and so are the special cases.  Those that
 * inner loops call go by tables (Tang, 1989 and 1990, ACM TOMS 15 and 16),
 * with the entries chosen so that reductions are exact without fused
 * products; the rest is rounded from 113 bits.  tests/core/test_elementary.c
 * holds each to its claim in units in the last place (ulps): exp 0.56, log
 * and log10 0.53, pow 0.6, expm1, log1p 1.2, cosh, sinh, asinh, atanh, tanh 3,
 * others 0.501.
 */
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <string.h>

#include "elementary_table.h"
#include "quad.h"

static uint64_t bits_of(double x)
{
    uint64_t bits;

    memcpy(&bits, &x, sizeof bits);
    return bits;
}

static double of_bits(uint64_t bits)
{
    double x;

    memcpy(&x, &bits, sizeof x);
    return x;
}

/* ---- e^x ----------------------------------------------------------------- */

/* e^(x + low) = 2^power of[0] (1 + of[1]) of |x| < 1e3, |low| small. */
static int exp_split(double x, double low, double of[2])
{
    const double magic = 0x1.8p52, shifted = x * EXP_UNIT + magic;
    const double n = shifted - magic;
    const double r = (x - n * EXP_HIGH) - n * EXP_LOW + low;
    const double p = EXP_REST(r);
    const int k = (int) n, i = k & (EXP_STEPS - 1);

    of[0] = exp_table[i][0];
    of[1] = exp_table[i][1] + p;
    return (k - i) / EXP_STEPS;
}

/* 2^k of a k that doubles hold as a normal number. */
static double two_to(int k)
{
    return of_bits((uint64_t) (k + 1023) << 52);
}

/* e^(x + low) */
static double exp_sum(double x, double low)
{
    if (!(fabs(x) < 1000.0))
        return x < 0.0 ? 0.0 : x + x > x ? HUGE_VAL : x;
    double of[2];
    const int k = exp_split(x, low, of), half = k / 2;
    const double value = of[0] + of[0] * of[1];

    return -1021 < k && k < 1022 ? value * two_to(k)
                                 : value * two_to(half) * two_to(k - half);
}

double exp(double x)
{
    return exp_sum(x, 0.0);
}

/* (e^x - 1 - x)/x^2 of |x| < 0.35 by its series. */
static double expm1_rest(double x)
{
    double sum = EXPM1_LAST;

    for (int n = 0; n < EXPM1_TERMS; n++)
        sum = sum * x + expm1_term[n];
    return sum;
}

double expm1(double x)
{
    if (fabs(x) < 0.35)
        return fabs(x) < 0x1p-54 ? x : x + x * x * expm1_rest(x);
    if (!(fabs(x) < 64.0))
        return x < 0.0 ? -1.0 : exp(x) - 1.0;
    double of[2];
    const double scale = two_to(exp_split(x, 0.0, of)) * of[0];

    return (scale - 1.0) + scale * of[1];
}

/* ---- ln x ---------------------------------------------------------------- */

/* ln(x + rest) = the result + *low, of a finite x > 0 and |rest| << x. */
static double log_split(double x, double rest, double *low)
{
    double scale = 0.0;

    if (x < 0x1p-1022) {
        x *= 0x1p54;
        rest *= 0x1p54;
        scale = -54.0;
    }
    const uint64_t from = bits_of(x) - LN_LOWEST;
    const int64_t power = (int64_t) from >> 52;
    const double part = of_bits(bits_of(x) - ((uint64_t) power << 52));
    const double upper = of_bits(bits_of(part) & 0xffffffff00000000);
    const double k = (double) power + scale;
    const unsigned i = from >> 46 & (LN_BINS - 1);
    const double c = ln_table[i].inverse;
    const double a = upper * c - 1.0, b = (part - upper) * c; /* exact */
    const double r = a + b, lost = (a - r) + b;
    const double first = k * LN2_HIGH + ln_table[i].high; /* exact */
    const double sum = first + r;
    const double series = LN_REST(r);

    *low = (first - sum) + r +
           (lost + rest / x + k * LN2_LOW + ln_table[i].low) + series;
    return sum;
}

/* Where ln x is no finite number. */
static double log_special(double x)
{
    return x == 0.0 ? -HUGE_VAL : x > 0.0 || x != x ? x : (double) NAN;
}

double log(double x)
{
    double low;

    if (!(x > 0.0 && x < HUGE_VAL))
        return log_special(x);
    const double high = log_split(x, 0.0, &low);
    return high + low;
}

double log1p(double x)
{
    double low;

    if (fabs(x) < 0x1p-54)
        return x;
    if (!(x > -1.0 && x < HUGE_VAL))
        return log_special(1.0 + x);
    const double sum = 1.0 + x, one = sum - x;
    const double rest = (1.0 - one) + (x - (sum - one));
    const double high = log_split(sum, rest, &low);
    return high + low;
}

/* ---- log10 x, x^y -------------------------------------------------------- */

/* The product of a and b is the result + *low (Veltkamp, Dekker 1971). */
static double product(double a, double b, double *low)
{
    const double upper = of_bits(bits_of(a) & 0xfffffffff8000000);
    const double top = of_bits(bits_of(b) & 0xfffffffff8000000);
    const double p = a * b;

    *low = ((upper * top - p) + upper * (b - top) + (a - upper) * top) +
           (a - upper) * (b - top);
    return p;
}

#define LOG10_E     0x1.bcb7b1526e50ep-2 /* log10 e, and by how much less */
#define LOG10_E_LOW 0x1.95355baaafad3p-57

double log10(double x)
{
    double low, left;

    if (!(x > 0.0 && x < HUGE_VAL))
        return log_special(x);
    double high = log_split(x, 0.0, &low);
    const double sum = high + low;

    low += high - sum;
    high = product(sum, LOG10_E, &left);
    return high + (left + low * LOG10_E + sum * LOG10_E_LOW);
}

double pow(double x, double y)
{
    double low, left;

    if (!(x > 0.0 && x < HUGE_VAL && fabs(y) < 1e10 && x != 1.0))
        return (double) powq(x, y);
    double high = log_split(x, 0.0, &low);
    const double sum = high + low;

    low += high - sum;
    high = product(sum, y, &left);
    return exp_sum(high, left + low * y);
}

/* ---- hyperbolic ---------------------------------------------------------- */

double sinh(double x)
{
    const double a = fabs(x), e = a < 700.0 ? expm1(a) : exp(0.5 * a);

    return copysign(a < 700.0 ? 0.5 * (e + e / (e + 1.0)) : 0.5 * e * e, x);
}

double cosh(double x)
{
    const double a = fabs(x), e = exp(a < 700.0 ? a : 0.5 * a);

    return a < 700.0 ? 0.5 * e + 0.5 / e : 0.5 * e * e;
}

double tanh(double x)
{
    const double e = expm1(2.0 * fmin(fabs(x), 30.0));

    return x != x ? x : copysign(e / (e + 2.0), x);
}

double asinh(double x)
{
    const double a = fabs(x), square = a * a;

    return copysign(a < 0x1p28 ? log1p(a + square / (1.0 + sqrt(1.0 + square)))
                               : log(a) + (LN2_HIGH + LN2_LOW),
                    x);
}

double atanh(double x)
{
    const double a = fabs(x);

    return copysign(0.5 * log1p(2.0 * a / (1.0 - a)), x);
}

/* ---- sin x, cos x -------------------------------------------------------- */

/* sin(x + quarters pi/2) of |x| < 2^30, x != 0, to less than 2^-60 of itself in
 * 64 bits, of which a double is rounded if that decides it; false: it does not.
 * k pi/2 goes in three parts, the first two of 33 bits, so that what is lost is
 * 2^-64 of what is left, and k 2^-132. */
static bool round_sin(double x, int quarters, double *out)
{
    static const long double part[] = {
        -1.0L / 2.0L,
        -1.0L / 6.0L,
        1.0L / 24.0L,
        1.0L / 120.0L,
        -1.0L / 720.0L,
        -1.0L / 5040.0L,
        1.0L / 40320.0L,
        1.0L / 362880.0L,
        -1.0L / 3628800.0L,
        -1.0L / 39916800.0L,
        1.0L / 479001600.0L,
        1.0L / 6227020800.0L,
        -1.0L / 87178291200.0L,
        -1.0L / 1307674368000.0L,
        1.0L / 20922789888000.0L,
        1.0L / 355687428096000.0L,
        -1.0L / 6402373705728000.0L,
        -1.0L / 121645100408832000.0L,
        1.0L / 2432902008176640000.0L,
        1.0L / 51090942171709440000.0L,
    };
    const double k = rint(x * 0x1.45f306dc9c883p-1);
    const long double r = ((x - k * 0x1921fb544p-32L) - k * 0x10b4611a6p-66L) -
                          k * 0x98cc51701b839a25p-132L;
    const unsigned turn = (unsigned) ((int64_t) k + quarters);
    const bool sine = turn % 2 == 0;
    const long double square = r * r;
    long double sum = 0.0L;

    for (int i = 18 + sine; i >= 0; i -= 2)
        sum = square * (part[i] + sum);
    sum = sine ? r + r * sum : 1.0L + sum;
    sum = turn / 2 % 2 ? -sum : sum;
    *out = (double) (sum - 0x1p-60L * sum);
    return *out == (double) (sum + 0x1p-60L * sum) &&
           (!sine || fabsl(r) >= 0x1p-70L * fabs(k));
}

static double sine(double x)
{
    double out;

    return fabs(x) < 0x1p30 && x != 0.0 && round_sin(x, 0, &out)
               ? out
               : (double) sinq(x);
}

static double cosine(double x)
{
    double out;

    return fabs(x) < 0x1p30 && round_sin(x, 1, &out) ? out : (double) cosq(x);
}

double sin(double x)
{
    return sine(x);
}

double cos(double x)
{
    return cosine(x);
}

/* What compilers make of both of one x. */
void sincos(double x, double *sin_x, double *cos_x)
{
    *sin_x = sine(x);
    *cos_x = cosine(x);
}

/* ---- rarely called: rounded from 113 bits -------------------------------- */

double tan(double x)
{
    return (double) tanq(x);
}

double atan(double x)
{
    return (double) atanq(x);
}

double atan2(double y, double x)
{
    return (double) atan2q(y, x);
}
