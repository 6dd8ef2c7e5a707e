#include "jet.h"

#include <math.h>
#include <string.h>

/* clang-format off */
const double jet_number[JET_SIZE] = {
    0,  1,  2,  3,  4,  5,  6,  7,  8,  9,  10, 11, 12, 13, 14, 15,
    16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31
};
const double jet_inverse[JET_SIZE] = {
    0,        1.0,      1.0 / 2,  1.0 / 3,  1.0 / 4,  1.0 / 5,  1.0 / 6,
    1.0 / 7,  1.0 / 8,  1.0 / 9,  1.0 / 10, 1.0 / 11, 1.0 / 12, 1.0 / 13,
    1.0 / 14, 1.0 / 15, 1.0 / 16, 1.0 / 17, 1.0 / 18, 1.0 / 19, 1.0 / 20,
    1.0 / 21, 1.0 / 22, 1.0 / 23, 1.0 / 24, 1.0 / 25, 1.0 / 26, 1.0 / 27,
    1.0 / 28, 1.0 / 29, 1.0 / 30, 1.0 / 31
};
/* clang-format on */

int jet_width(void)
{
#ifdef __x86_64__
    if (__builtin_cpu_supports("avx512f") &&
        __builtin_cpu_supports("avx512dq") &&
        __builtin_cpu_supports("avx512vl"))
        return 8;
    if (__builtin_cpu_supports("avx2"))
        return 4;
#endif
    return 2;
}

double jet_at(size_t order, const double u[], double s)
{
    double sum = u[order];

    for (size_t j = order; j-- > 0;)
        sum = sum * s + u[j];
    return sum;
}

double jet_slope_at(size_t order, const double u[], double s)
{
    double sum = 0.0;

    for (size_t j = order; j >= 1; j--)
        sum = sum * s + (double) j * u[j];
    return sum;
}

/* Each term |u[k]| C(k, j) |s|^(k - j) h^j is rounded no more than 4 (order +
 * 1) times, by half a DBL_EPSILON of itself. */
double jet_spread_at(size_t order, const double u[], double s, double h)
{
    double c[JET_SIZE], power = 1.0, sum = 0.0;

    memcpy(c, u, (order + 1) * sizeof *c);
    for (size_t k = 0; k < order; k++)
        for (size_t j = order; j-- > k;)
            c[j] += s * c[j + 1];
    for (size_t k = 1; k <= order; k++)
        sum += fabs(c[k]) * (power *= h);
    return sum;
}
