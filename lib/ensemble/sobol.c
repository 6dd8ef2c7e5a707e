/* GSL gives points one after another, in the order of Gray's code: point n
 * differs from n - 1 by the direction number of the lowest one bit of n.  So
 * the numbers are told by points 2^k, and point n is the sum (mod 2) of those
 * of the bits of n ^ (n >> 1) (Antonov & Saleev 1979). */
#include "sobol.h"

#include <gsl/gsl_qrng.h>

/* The finaliser of splitmix64 (Steele, Lea, Flood, OOPSLA 2014). */
static uint64_t mixed(uint64_t z)
{
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

uint64_t sobol_hash(uint64_t a, uint64_t b)
{
    return mixed(mixed(a + 0x9e3779b97f4a7c15u) ^
                 (b + 0x9e3779b97f4a7c15u) * 0xd1342543de82ef95u);
}

double sobol_unit(uint64_t bits)
{
    return ((double) (bits >> 12) + 0.5) * 0x1p-52;
}

enum status sobol_init(struct sobol *s, size_t dimensions, size_t points)
{
    double at[SOBOL_DIMENSIONS] = { 0.0 }, was[SOBOL_DIMENSIONS] = { 0.0 };
    gsl_qrng *q = gsl_qrng_alloc(gsl_qrng_sobol, (unsigned) dimensions);

    *s = (struct sobol){ .dimensions = dimensions };
    if (q == NULL)
        return STATUS_NO_MEMORY;
    for (size_t n = 1, k = 0; n < 2 || n / 2 < points; n++) {
        gsl_qrng_get(q, at);
        const size_t power = (size_t) 1 << k;
        for (size_t d = 0; d < dimensions; d++) {
            if (n == power)
                s->turn[d][k] =
                    (uint32_t) (at[d] * 0x1p30) ^ (uint32_t) (was[d] * 0x1p30);
            was[d] = at[d];
        }
        k += n == power;
        if (k == SOBOL_BITS || power >= points)
            break;
    }
    gsl_qrng_free(q);
    return STATUS_OK;
}

/* Digit by digit from the first on: whether it is flipped hangs on its place
 * and on all before it. */
static uint32_t scrambled(uint32_t x, uint64_t seed)
{
    uint32_t out = 0;

    for (int bit = SOBOL_BITS - 1; bit >= 0; bit--) {
        const uint32_t before = x >> (bit + 1);
        const uint64_t place = (uint64_t) (bit + 1) << 32 | before;
        out |= ((x >> bit ^ (uint32_t) (sobol_hash(seed, place) >> 63)) & 1u)
               << bit;
    }
    return out;
}

double sobol_at(const struct sobol *s, size_t point, size_t dimension,
                uint64_t seed)
{
    const uint64_t own = sobol_hash(seed, dimension);
    uint32_t x = 0;

    for (size_t gray = point ^ (point >> 1), k = 0; gray; gray >>= 1, k++)
        if (gray & 1)
            x ^= s->turn[dimension][k];
    const uint64_t rest = sobol_hash(own, x) >> SOBOL_BITS;
    return sobol_unit((uint64_t) scrambled(x, own) << (64 - SOBOL_BITS) | rest);
}
