/*
 * quad_exp.c -- e^x in 113 bits by whole numbers of 128: glibc's takes ten
 * times as long, in 113-bit sums and products of software.
 *
 * e^x = 2^k (1 + y), 0 <= y < 1, with r = x - k ln 2 in [0, ln 2) and y = e^r -
 * 1 by the series at r/64, doubled six times as 2 y + y^2.  All are fractions
 * in units of 2^-128, where whole parts fall off.  Each step falls short by at
 * most 4 units, the series and r by 8; doubled, y by less than 2^10 units: e^x
 * is off by at most 0.51 ulps.  tests/core/test_quad_exp.c holds it to that.
 */
#include <stdbool.h>
#include <stdint.h>
#include <string.h>

#include "quad.h"

__extension__ typedef unsigned __int128 fraction;

enum { DOUBLINGS = 6, BIAS = 16383, DIGITS = 112 };

#define WORDS(high, low) ((fraction) (high) << 64 | (low))

/* ln 2, and its next 64 bits. */
static const fraction ln2 = WORDS(0xb17217f7d1cf79ab, 0xc9e3b39803f2f6af);
static const uint64_t ln2_rest = 0x40f343267298b62d;

static fraction times(fraction a, fraction b)
{
    const uint64_t a1 = (uint64_t) (a >> 64), a0 = (uint64_t) a;
    const uint64_t b1 = (uint64_t) (b >> 64), b0 = (uint64_t) b;
    const fraction left = (fraction) a1 * b0 + ((fraction) a0 * b0 >> 64);
    const fraction right = (fraction) a0 * b1 + (uint64_t) left;

    return (fraction) a1 * b1 + (uint64_t) (left >> 64) +
           (uint64_t) (right >> 64);
}

#define PART(factorial) (~(fraction) 0 / (factorial))

/* e^r - 1 - r of r < 0.011: what is left out is less than 2^-137.  Of the last
 * terms, below 2^-15 before powers of r, 64 bits are enough. */
static fraction curved(fraction r)
{
    static const fraction large[] = { PART(2),   PART(6),   PART(24),
                                      PART(120), PART(720), PART(5040) };
    static const uint64_t small[] = {
        PART(40320) >> 49,       PART(362880) >> 49,    PART(3628800) >> 49,
        PART(39916800) >> 49,    PART(479001600) >> 49, PART(6227020800) >> 49,
        PART(87178291200) >> 49,
    };
    const uint64_t top = (uint64_t) (r >> 64);
    uint64_t rest = 0;

    for (int n = sizeof small / sizeof *small; n-- > 0;)
        rest = small[n] + (uint64_t) ((fraction) rest * top >> 64);
    fraction sum = (fraction) rest << 49;
    for (int n = sizeof large / sizeof *large; n-- > 0;)
        sum = large[n] + times(sum, r);
    return times(times(r, r), sum);
}

static fraction shifted(fraction digits, int left)
{
    return left >= 0 ? digits << left : left > -128 ? digits >> -left : 0;
}

/* r = x - *k ln 2 of a number 2^exponent digits/2^112 below 2^13. */
static fraction reduced(bool negative, int exponent, fraction digits, int *k)
{
    const double far = 20000.0;
    const double size =
        (double) (int64_t) shifted(digits, exponent - DIGITS + 40);
    const double turns = (negative ? -size : size) * 0x1.71547652b82fep-40;
    const fraction part = shifted(digits, exponent - DIGITS + 128);

    *k = (int) (turns + (far - 0x1p-20)) - (int) far; /* or one too few */
    const fraction n = (fraction) (*k < 0 ? -*k : *k);
    const fraction whole = n * ln2 + (n * ln2_rest >> 64);
    const fraction r = (negative ? -part : part) - (*k < 0 ? -whole : whole);

    if (r < ln2)
        return r;
    ++*k;
    return r - ln2;
}

quad expq(quad x)
{
    const fraction one = (fraction) 1 << DIGITS;
    fraction bits;
    int k;

    memcpy(&bits, &x, sizeof bits);
    const int exponent = (int) (bits >> DIGITS & 0x7fff) - BIAS;
    if (exponent > 12)
        return quad_libm_exp(x);
    const fraction r =
        reduced(bits >> 127, exponent, (bits & (one - 1)) | one, &k);
    fraction y = (r >> DOUBLINGS) + curved(r >> DOUBLINGS);

    for (int i = 0; i < DOUBLINGS; i++)
        y += y + times(y, y);
    bits = ((fraction) (k + BIAS) << DIGITS) + (y >> (128 - DIGITS)) +
           (y >> (127 - DIGITS) & 1);
    memcpy(&x, &bits, sizeof x);
    return x;
}
