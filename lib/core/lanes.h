/*
 * lanes.h -- several doubles side by side, each in its own lane: what one lane
 * holds never touches another.  The including file defines LANES, 1, 2, 4
 * or 8, and is compiled once for each processor whose registers hold that many;
 * the bits of a lane are the same in all, for nothing here depends on LANES and
 * nothing multiplies and adds in one rounding, which not all can.
 *
 * e^x and ln x: the argument is reduced by a power of 2, the rest is a series
 * (Muller et al., Handbook of Floating-Point Arithmetic, 2018, ch. 10), to
 * some 2 units in the last place.
 */
#pragma once

#include <math.h>
#include <stdint.h>

typedef double lanes __attribute__((vector_size(8 * LANES)));
typedef uint64_t lanes_bits __attribute__((vector_size(8 * LANES)));

/* A plain number or a lanes as lanes. */
#define LANES_OF(x) ((x) - (lanes){ 0 })

/* ---- choices ------------------------------------------------------------- */

/* Lane by lane a < b ? p : q. */
static inline lanes lanes_less(lanes a, lanes b, lanes p, lanes q)
{
    const lanes_bits mask = (lanes_bits) (a < b);

    return (lanes) ((mask & (lanes_bits) p) | (~mask & (lanes_bits) q));
}

/* Whether a < b in any lane. */
static inline int lanes_any_less(lanes a, lanes b)
{
    const lanes_bits mask = (lanes_bits) (a < b);
    uint64_t any = 0;

    for (int i = 0; i < LANES; i++)
        any |= mask[i];
    return any != 0;
}

static inline lanes lanes_larger(lanes a, lanes b)
{
    lanes c = a;

    for (int i = 0; i < LANES; i++)
        c[i] = a[i] > b[i] ? a[i] : b[i];
    return c;
}

static inline lanes lanes_smaller(lanes a, lanes b)
{
    lanes c = a;

    for (int i = 0; i < LANES; i++)
        c[i] = a[i] < b[i] ? a[i] : b[i];
    return c;
}

static inline lanes lanes_size(lanes x)
{
    return (lanes) ((lanes_bits) x & INT64_MAX);
}

/* |x| with the sign of s. */
static inline lanes lanes_signed(lanes x, lanes s)
{
    const lanes_bits sign = (lanes_bits) s & (1ull << 63);
    return (lanes) (((lanes_bits) x & INT64_MAX) | sign);
}

static inline lanes lanes_root(lanes x)
{
    for (int i = 0; i < LANES; i++)
        x[i] = sqrt(x[i]);
    return x;
}

/* p + q x */
static inline lanes lanes_line(double p, double q, lanes x)
{
    return q * x + p;
}

/* ---- e^x ----------------------------------------------------------------- */

#define LANES_LN2_HIGH 0x1.62e42fefa3800p-1 /* 42 bits */
#define LANES_LN2_LOW  0x1.ef35793c76730p-45

/* e^x = two (1 + rest), two a power of 2; x is cut off at what doubles hold. */
static inline lanes lanes_split_exp(lanes x, lanes *two)
{
    const double magic = 0x1.8p52, fold = 0x1.71547652b82fep0; /* 1/ln 2 */

    x = lanes_larger(LANES_OF(-708.0), lanes_smaller(LANES_OF(709.0), x));
    const lanes shifted = lanes_line(magic, fold, x), n = shifted - magic;
    const lanes r = (x - n * LANES_LN2_HIGH) - n * LANES_LN2_LOW;
    const lanes r2 = r * r, r4 = r2 * r2;
    const lanes a = lanes_line(1.0 / 24, 1.0 / 120, r) * r2 +
                    lanes_line(1.0 / 2, 1.0 / 6, r);
    const lanes b = lanes_line(1.0 / 40320, 1.0 / 362880, r) * r2 +
                    lanes_line(1.0 / 720, 1.0 / 5040, r);
    const lanes c = lanes_line(1.0 / 479001600, 1.0 / 6227020800, r) * r2 +
                    lanes_line(1.0 / 3628800, 1.0 / 39916800, r);
    *two = (lanes) (((lanes_bits) shifted + 1023) << 52);
    return ((c * r4 + b) * r4 + a) * r2 + r;
}

static inline lanes lanes_exp(lanes x)
{
    lanes two;
    const lanes rest = lanes_split_exp(x, &two);

    return two * rest + two;
}

/* e^x - 1, and e^x to all its digits */
static inline lanes lanes_em1_exp(lanes x, lanes *e)
{
    lanes two;
    const lanes rest = lanes_split_exp(x, &two), part = two * rest;

    *e = part + two;
    return part + (two - 1.0);
}

/* e^x - 1 */
static inline lanes lanes_em1(lanes x)
{
    lanes e;

    return lanes_em1_exp(x, &e);
}

/* ---- ln x ---------------------------------------------------------------- */

/* ln x of x > 0, of which x - 1 = `less` where x is near 1. */
static inline lanes lanes_ln_near(lanes x, lanes less)
{
    const uint64_t low = 0x3fe6a09e667f3bcd, one = 0x3ff0000000000000;
    const lanes_bits bits = (lanes_bits) x - low + one; /* x/sqrt(1/2) */
    const lanes_bits power = bits >> 52, part = bits & 0xfffffffffffff;
    const lanes n = (lanes) (power | 0x4330000000000000) - (0x1p52 + 1023.0);
    const lanes f = lanes_less(lanes_size(n), LANES_OF(0.5), less,
                               (lanes) (part + low) - 1.0);
    const lanes s = f / (2.0 + f), z = s * s, z2 = z * z, z4 = z2 * z2;
    const lanes a =
        lanes_line(1.0 / 7, 1.0 / 9, z) * z2 + lanes_line(1.0 / 3, 1.0 / 5, z);
    const lanes b = lanes_line(1.0 / 15, 1.0 / 17, z) * z2 +
                    lanes_line(1.0 / 11, 1.0 / 13, z);
    const lanes c = lanes_line(1.0 / 19, 1.0 / 21, z);
    const lanes sum = (c * z4 + b) * z4 + a;
    const lanes low_part = n * LANES_LN2_LOW + x * 0.0;
    const lanes rest = s * z * (2.0 * sum) + low_part;
    return n * LANES_LN2_HIGH + (2.0 * s + rest);
}

static inline lanes lanes_ln(lanes x)
{
    return lanes_ln_near(x, x - 1.0);
}

/* ln(1 + x) */
static inline lanes lanes_ln1p(lanes x)
{
    return lanes_ln_near(1.0 + x, x);
}
