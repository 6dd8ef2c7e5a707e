/* Sums run in four lanes whose order is fixed here, not by the compiler, so
 * that the same numbers come out of every instruction set. */
#include "jet.h"

#include <string.h>

typedef double pair __attribute__((vector_size(16)));
struct lanes {
    pair low, high;
};

static inline pair load(const double *p)
{
    pair q;
    memcpy(&q, p, sizeof q);
    return q;
}

/* {p[0], p[-1]} */
static inline pair load_back(const double *p)
{
    const pair q = load(p - 1);
    return (pair){ q[1], q[0] };
}

/* lanes += u[0..3] * v[0..-3] */
static inline void add_products(struct lanes *sum, const double *u,
                                const double *v)
{
    sum->low += load(u) * load_back(v);
    sum->high += load(u + 2) * load_back(v - 2);
}

static inline double sum_of(struct lanes s)
{
    const pair q = s.low + s.high;
    return q[0] + q[1];
}

static const double number[JET_SIZE] = { 0,  1,  2,  3,  4,  5,  6,  7,
                                         8,  9,  10, 11, 12, 13, 14, 15,
                                         16, 17, 18, 19, 20, 21, 22, 23,
                                         24, 25, 26, 27, 28, 29, 30, 31 };

double jet_product(size_t k, const double u[], const double v[])
{
    struct lanes sum = { 0 };
    size_t j = 0;

    for (; j + 3 <= k; j += 4)
        add_products(&sum, u + j, v + k - j);
    double rest = 0.0;
    for (; j <= k; j++)
        rest += u[j] * v[k - j];
    return sum_of(sum) + rest;
}

double jet_chain(const struct jet_work *w, size_t k, const double u[],
                 const double v[])
{
    struct lanes sum = { 0 };
    size_t j = 1;

    if (u == w->linear)
        return u[1] * v[k - 1];
    for (; j + 3 <= k; j += 4) {
        sum.low += load(number + j) * load(u + j) * load_back(v + k - j);
        sum.high +=
            load(number + j + 2) * load(u + j + 2) * load_back(v + k - j - 2);
    }
    double rest = 0.0;
    for (; j <= k; j++)
        rest += number[j] * u[j] * v[k - j];
    return sum_of(sum) + rest;
}

double jet_quotient(size_t k, const double num[], const double den[],
                    const double quotient[])
{
    struct lanes sum = { 0 };
    size_t j = 0;

    for (; j + 4 <= k; j += 4)
        add_products(&sum, quotient + j, den + k - j);
    double rest = 0.0;
    for (; j < k; j++)
        rest += quotient[j] * den[k - j];
    return (num[k] - (sum_of(sum) + rest)) / den[0];
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
