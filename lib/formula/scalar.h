/*
 * scalar.h -- the delicate scalar functions behind every kind of number: order
 * 0 of an operation is the same code everywhere.  The including file defines
 *     SCALAR   the scalar type,
 *     FN(f)    the mathematical function f for this type (FN(exp), ...).
 */
#pragma once

static inline SCALAR scalar_larger(SCALAR u, SCALAR w)
{
    return u > w ? u : w;
}

/* e^u - 1 and ln(1 + x), where the plain way, several times faster, is as
 * good: the difference, the sum is not near what it is made of */
static inline SCALAR scalar_em1(SCALAR u)
{
    return u > 1 || u < -1 ? FN(exp)(u) - 1 : FN(expm1)(u);
}

static inline SCALAR scalar_ln1p(SCALAR x)
{
    return x > 1 ? FN(log)(1 + x) : FN(log1p)(x);
}

/* p e^u, where e^u may overflow and the product does not */
static inline SCALAR scalar_exp(SCALAR p, SCALAR u)
{
    const SCALAR half = FN(exp)(u / 2);
    return p * half * half;
}

/* p (e^u - 1), log_p = ln |p|; p may under- or overflow where the product
 * does not. */
static inline SCALAR scalar_expm1(SCALAR p, SCALAR log_p, SCALAR u)
{
    if (u > 1)
        return FN(copysign)(FN(exp)(log_p + u), p) - p;
    return p * scalar_em1(u);
}

/* p (e^u - e^w): the larger times 1 - their ratio */
static inline SCALAR scalar_difference(SCALAR p, SCALAR u, SCALAR w)
{
    if (u > w)
        return -scalar_exp(p, u) * scalar_em1(w - u);
    return scalar_exp(p, w) * scalar_em1(u - w);
}

/* e^-|u| sinh u */
static inline SCALAR scalar_sinh(SCALAR u)
{
    return FN(copysign)(scalar_em1(-2 * FN(fabs)(u)) / 2, u);
}

/* ln(1 + r (e^u - 1)) = ln(r e^u + s), r + s = 1: both are given, because the
 * smaller has no digits left in the other */
static inline SCALAR scalar_log1p_expm1(SCALAR r, SCALAR s, SCALAR u)
{
    if (s == 0)
        return u;
    if (u > 700)
        return u + FN(log)(r + s * FN(exp)(-u));
    const SCALAR change = r * scalar_em1(u);
    return 2 * change > -1 ? scalar_ln1p(change) : FN(log)(s + r * FN(exp)(u));
}

/* d/du of the above, r e^u/(r e^u + s), and 1 - it, s/(r e^u + s) */
static inline SCALAR scalar_logistic(SCALAR r, SCALAR s, SCALAR u)
{
    const SCALAR e = FN(exp)(-FN(fabs)(u));
    return s == 0 ? 1 : u < 0 ? r * e / (r * e + s) : r / (r + s * e);
}

static inline SCALAR scalar_logistic_rest(SCALAR r, SCALAR s, SCALAR u)
{
    return s == 0 ? 0 : scalar_logistic(s, r, -u);
}

/* asinh(e^w/2) for any w */
static inline SCALAR scalar_asinh_exp(SCALAR w)
{
    if (w > 1)
        return w + scalar_ln1p((FN(sqrt)(1 + 4 * FN(exp)(-2 * w)) - 1) / 2);
    return FN(asinh)(FN(exp)(w) / 2);
}

/* W(exp(-k)), Lambert's W, from w + exp(w) = -k with w = ln W */
static inline SCALAR scalar_lambert(SCALAR k)
{
    SCALAR w = k > 1 ? -k : (SCALAR) -1, before = 2;

    for (int i = 0; i < 60; i++) { /* until rounding is all that moves it */
        const SCALAR e = FN(exp)(w), step = (w + e + k) / (1 + e);
        if (!(FN(fabs)(step) < before) || w - step == w)
            break;
        before = FN(fabs)(step);
        w -= step;
    }
    return FN(exp)(w);
}

/* asinh(e^(w0 + u)/2) - asinh(e^w0/2), q0 = 4 e^(-2 w0).  The difference is
 * asinh(t root0 - t0 root), t = e^w/2, root = sqrt(1 + t^2), times what makes
 * t^2 - t0^2 of it. */
static inline SCALAR scalar_friction(SCALAR w0, SCALAR q0, SCALAR u)
{
    const SCALAR w = w0 + u, fair = 0.7;

    if (w0 > fair && w > fair) { /* both t > 1 */
        const SCALAR q = 4 * FN(exp)(-2 * w);
        const SCALAR dq =
            u < 0 ? -q * scalar_em1(2 * u) : q0 * scalar_em1(-2 * u);
        const SCALAR s0 = FN(sqrt)(1 + q0), s = FN(sqrt)(1 + q);
        return u + scalar_ln1p(dq / ((s + s0) * (1 + s0)));
    }
    if (FN(fabs)(u) < 1) {
        const SCALAR t0 = FN(exp)(w0) / 2, e = FN(exp)(u), t = t0 * e;
        const SCALAR root0 = FN(sqrt)(1 + t0 * t0), root = FN(sqrt)(1 + t * t);
        return FN(asinh)(t0 * scalar_em1(2 * u) / (e * root0 + root));
    }
    return scalar_asinh_exp(w) - scalar_asinh_exp(w0);
}

/* d/du of the above, tanh of asinh(e^w/2) */
static inline SCALAR scalar_friction_slope(SCALAR w)
{
    return w > 0 ? 1 / FN(sqrt)(1 + 4 * FN(exp)(-2 * w))
                 : FN(exp)(w) / FN(sqrt)(FN(exp)(2 * w) + 4);
}
