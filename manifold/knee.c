/*
 * Knees of a branch.  Crossings are bracketed on the stored polynomials and
 * count only where the field's slope crosses too; each is located twice, on
 * the polynomial's derivative and on the field's slope along the polynomial,
 * and the difference of the two is the error.
 */
#include "knee.h"

#include <float.h>
#include <math.h>

enum { SAMPLES = 12 };

struct seeker {
    const struct planar *sys;
    const struct branch *b;
    size_t piece;
};

/* Sign as of dy/dx - 1, smooth also where the branch is vertical. */
static double by_polynomial(const struct seeker *s, double theta)
{
    double d[CURVE_DIM_MAX];

    curve_slope_at(&s->b->curve, s->piece, theta, d);
    return copysign(1.0, d[0]) * (d[1] - d[0]);
}

static double by_field(const struct seeker *s, double theta)
{
    double at[CURVE_DIM_MAX];
    struct planar_field f;

    curve_at(&s->b->curve, s->piece, theta, at);
    s->sys->field(s->sys->ctx, (struct vec2){ at[0], at[1] }, &f);
    return copysign(1.0, f.direction.x) * (f.direction.y - f.direction.x);
}

typedef double seeker_function(const struct seeker *s, double theta);

/* A root in [lo, hi], where f changes sign: bracketed secant steps. */
static double root_in(seeker_function *f, const struct seeker *s, double lo,
                      double hi)
{
    double at_lo = f(s, lo), at_hi = f(s, hi);
    int side = 0;

    for (int i = 0; i < 100 && hi - lo > DBL_EPSILON; i++) {
        double t = hi - at_hi * (hi - lo) / (at_hi - at_lo);
        if (!(t > lo && t < hi) || i % 8 == 7)
            t = 0.5 * (lo + hi);
        const double at = f(s, t);
        if (at == 0.0)
            return t;
        if ((at < 0.0) == (at_lo < 0.0)) {
            lo = t, at_lo = at;
            at_hi *= side < 0 ? 0.5 : 1.0;
            side = -1;
        } else {
            hi = t, at_hi = at;
            at_lo *= side > 0 ? 0.5 : 1.0;
            side = 1;
        }
    }
    return 0.5 * (lo + hi);
}

static struct vec2 point_of(const struct seeker *s, double theta)
{
    double at[CURVE_DIM_MAX];

    curve_at(&s->b->curve, s->piece, theta, at);
    return (struct vec2){ at[0], at[1] };
}

static double piece_error(const struct seeker *s)
{
    return s->b->curve.piece[s->piece].error;
}

/* How far the field's slope is off at z, where it is 1: what the curve's error
 * does to it - whether that is along x or y makes a difference of as much as
 * the error itself to the knee - and rounding. */
static double slope_uncertainty(const struct seeker *s, struct vec2 z)
{
    struct planar_jacobian J;

    s->sys->jacobian(s->sys->ctx, z, &J);
    const struct mat2 m = J.matrix;
    const double fx = J.field.direction.x;
    const double by_y = (m.yy - m.xy) / fx, by_x = (m.yx - m.xx) / fx;
    const double noise =
        4.0 * DBL_EPSILON * (4.0 + fabs(by_x * z.x) + fabs(by_y * z.y));
    return noise + fmin(fabs(by_x), fabs(by_y)) * piece_error(s);
}

/* d slope/d theta along the curve. */
static double bend(const struct seeker *s, double theta)
{
    const double h = 1e-4;
    const double lo = fmax(theta - h, 0.0), hi = fmin(theta + h, 1.0);
    const double below = local_slope(s->sys, 0, point_of(s, lo));
    const double above = local_slope(s->sys, 0, point_of(s, hi));

    return fabs(above - below) / (hi - lo);
}

/* The crossing in [lo, hi] by both routes; false where the field's slope does
 * not cross in [wide_lo, wide_hi] around it. */
static bool locate(const struct seeker *s, double lo, double hi, bool rising,
                   struct knee *out)
{
    const double wide_lo = fmax(lo - (hi - lo), 0.0);
    const double wide_hi = fmin(hi + (hi - lo), 1.0);
    const double at_lo = by_field(s, wide_lo), at_hi = by_field(s, wide_hi);

    if (!((at_lo < 0.0) != (at_hi < 0.0)))
        return false;
    const double first = root_in(by_polynomial, s, lo, hi);
    const double second = root_in(by_field, s, wide_lo, wide_hi);
    const struct vec2 p = point_of(s, first), q = point_of(s, second);
    const double off = slope_uncertainty(s, q), shift = off / bend(s, second);
    double d[CURVE_DIM_MAX];
    curve_slope_at(&s->b->curve, s->piece, second, d);
    const double floor = 2.0 * piece_error(s) + 4.0 * DBL_EPSILON;

    *out = (struct knee){
        .z = q,
        .error = { 2.0 * fabs(p.x - q.x) + fabs(d[0]) * shift +
                       floor * (1.0 + fabs(q.x)),
                   2.0 * fabs(p.y - q.y) + fabs(d[1]) * shift +
                       floor * (1.0 + fabs(q.y)) },
        .rising = rising,
    };
    return true;
}

size_t knee_find(const struct planar *sys, const struct branch *b,
                 struct knee knee[], size_t room)
{
    struct seeker s = { sys, b, 0 };
    size_t n = 0;

    for (; s.piece < b->curve.count; s.piece++) {
        double lo = 0.0, at_lo = by_polynomial(&s, 0.0);
        for (int i = 1; i <= SAMPLES; i++) {
            const double hi = (double) i / SAMPLES;
            const double at_hi = by_polynomial(&s, hi);
            struct knee found;
            if ((at_lo < 0.0) != (at_hi < 0.0) &&
                locate(&s, lo, hi, at_lo < 0.0, &found)) {
                if (n < room)
                    knee[n] = found;
                n++;
            }
            lo = hi;
            at_lo = at_hi;
        }
    }
    return n;
}
