#include "jet.h"

double jet_product(size_t k, const double u[], const double v[])
{
    double even = 0.0, odd = 0.0;
    size_t j = 0;

    for (; j + 1 <= k; j += 2) {
        even += u[j] * v[k - j];
        odd += u[j + 1] * v[k - j - 1];
    }
    if (j <= k)
        even += u[j] * v[k - j];
    return even + odd;
}

double jet_chain(const struct jet_work *w, size_t k, const double u[],
                 const double v[])
{
    double even = 0.0, odd = 0.0;
    size_t j = 1;

    if (u == w->linear)
        return u[1] * v[k - 1];
    for (; j + 1 <= k; j += 2) {
        even += (double) j * u[j] * v[k - j];
        odd += (double) (j + 1) * u[j + 1] * v[k - j - 1];
    }
    if (j <= k)
        even += (double) j * u[j] * v[k - j];
    return even + odd;
}

double jet_quotient(size_t k, const double num[], const double den[],
                    const double quotient[])
{
    double sum = num[k];

    for (size_t j = 0; j < k; j++)
        sum -= quotient[j] * den[k - j];
    return sum / den[0];
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
