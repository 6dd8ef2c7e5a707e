/*
 * change.h -- f(k + u) - f(k) without cancellation, and the slope of f at
 * k + u, for the steps of a tape; SCALAR and FN as in scalar.h.
 */
#pragma once

#include "scalar.h"

/* p (cos u - 1) + q sin u, and its slope */
static inline SCALAR change_sin(SCALAR p, SCALAR q, SCALAR u)
{
    const SCALAR s = FN(sin)(u / 2), c = FN(cos)(u / 2);
    return 2 * s * (q * c - p * s);
}

static inline SCALAR change_sin_slope(SCALAR p, SCALAR q, SCALAR u)
{
    return q * FN(cos)(u) - p * FN(sin)(u);
}

static inline SCALAR change_cosh(SCALAR k, SCALAR u)
{
    return 2 * FN(sinh)(u / 2) * FN(sinh)(k + u / 2);
}

/* p and q: cosine and sine of k; the tangent at k + u, too */
static inline SCALAR change_tan(SCALAR p, SCALAR q, SCALAR u)
{
    const SCALAR s = FN(sin)(u), c = FN(cos)(u);
    return s / ((p * c - q * s) * p);
}

static inline SCALAR change_tangent(SCALAR p, SCALAR q, SCALAR u)
{
    const SCALAR s = FN(sin)(u), c = FN(cos)(u);
    return (q * c + p * s) / (p * c - q * s);
}

/* 1/cosh(w)^2 */
static inline SCALAR change_tanh_slope(SCALAR w)
{
    const SCALAR e = FN(exp)(-2 * FN(fabs)(w));
    return 4 * e / ((1 + e) * (1 + e));
}

/* sinh u/(cosh k cosh(k + u)); |u| - |k| - |k + u| is 0 or -2 |the smaller| */
static inline SCALAR change_tanh(SCALAR k, SCALAR u)
{
    const SCALAR w = k + u, a = FN(fabs)(k), b = FN(fabs)(w);
    const SCALAR cosh2 = (1 + FN(exp)(-2 * a)) * (1 + FN(exp)(-2 * b));
    const SCALAR size = (k < 0) == (w < 0) ? -2 * (a < b ? a : b) : 0;
    return 4 * scalar_sinh(u) * FN(exp)(size) / cosh2;
}

/* The angle from k to k + u. */
static inline SCALAR change_atan(SCALAR k, SCALAR u)
{
    return FN(atan2)(u, 1 + k * (k + u));
}

/* (w^2 - k^2)/(w p + k q) where w and k have one sign, else w p - k q: w p - k
 * q for p^2 - q^2 = s (w^2 - k^2), s = -1 or 1, without cancellation */
static inline SCALAR change_cross(SCALAR k, SCALAR u, SCALAR p, SCALAR q)
{
    const SCALAR w = k + u;
    return (k > 0 && w > 0) || (k < 0 && w < 0) ? u * (w + k) / (w * p + k * q)
                                                : w * p - k * q;
}

static inline SCALAR change_root(SCALAR w)
{
    return FN(sqrt)((1 - w) * (1 + w));
}

static inline SCALAR change_asin(SCALAR k, SCALAR u)
{
    const SCALAR w = k + u, p = change_root(k), q = change_root(w);
    return FN(atan2)(change_cross(k, u, p, q), p * q + w * k);
}

/* sqrt(1 + w^2) */
static inline SCALAR change_length(SCALAR w)
{
    const SCALAR size = FN(fabs)(w), far = 1e9;
    return size > far * far ? size : FN(sqrt)(1 + w * w);
}

static inline SCALAR change_asinh(SCALAR k, SCALAR u)
{
    const SCALAR w = k + u, far = 1e150;
    if (w > far || w < -far)
        return FN(asinh)(w) - FN(asinh)(k);
    return FN(asinh)(change_cross(k, u, change_length(k), change_length(w)));
}
