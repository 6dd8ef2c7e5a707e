/*
 * scalar.h -- the delicate scalar functions behind every kind of number, in
 * double: order 0 of an operation is the same code everywhere.
 */
#ifndef FRICTION_SCALAR_H
#define FRICTION_SCALAR_H

#include <math.h>

/* p (e^u - 1), log_p = ln |p|; p may under- or overflow where the product
 * does not. */
static inline double scalar_expm1(double p, double log_p, double u)
{
    if (u > 1.0)
        return copysign(exp(log_p + u), p) - p;
    return p * expm1(u);
}

/* ln(1 + r (e^u - 1)), 0 <= r <= 1 */
static inline double scalar_log1p_expm1(double r, double u)
{
    if (r == 1.0)
        return u;
    if (u > 700.0)
        return u + log(r + (1.0 - r) * exp(-u));
    return log1p(r * expm1(u));
}

/* d/du of the above: r e^u/(1 + r (e^u - 1)) */
static inline double scalar_logistic(double r, double u)
{
    return r / (r + (1.0 - r) * exp(-u));
}

/* asinh(e^w/2) for any w */
static inline double scalar_asinh_exp(double w)
{
    if (w > 1.0)
        return w + log1p(0.5 * (sqrt(1.0 + 4.0 * exp(-2.0 * w)) - 1.0));
    return asinh(0.5 * exp(w));
}

/* asinh(e^(w0 + u)/2) - asinh(e^w0/2), q0 = 4 e^(-2 w0) */
static inline double scalar_friction(double w0, double q0, double u)
{
    const double w = w0 + u;

    if (w0 > 0.7 && w > 0.7) { /* both e^w/2 > 1 */
        const double s0 = sqrt(1.0 + q0), s = sqrt(1.0 + q0 * exp(-2.0 * u));
        const double ds = q0 * expm1(-2.0 * u) / (s + s0);
        return u + log1p(ds / (1.0 + s0));
    }
    if (fabs(u) < 1.0) {
        const double t0 = 0.5 * exp(w0), t = 0.5 * exp(w);
        const double root0 = sqrt(1.0 + t0 * t0), root = sqrt(1.0 + t * t);
        return asinh(t0 * t0 * expm1(2.0 * u) / (t * root0 + t0 * root));
    }
    return scalar_asinh_exp(w) - scalar_asinh_exp(w0);
}

/* 1 - (d/du of the above)^2 = 1/(1 + e^(2w)/4) */
static inline double scalar_friction_bend(double w0, double u)
{
    const double e = exp(-2.0 * (w0 + u));
    return isinf(e) ? 1.0 : 4.0 * e / (1.0 + 4.0 * e);
}

#endif
