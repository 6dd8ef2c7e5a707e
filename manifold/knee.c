/*
 * Knees of a branch: sign changes of the field's slope less 1 along the stored
 * polynomials, from piece to piece without a gap.  What the polynomials' own
 * slope is off there, together with the curve's error, is the error.
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

/* Sign as of dy/dx - 1, smooth also where the branch is vertical: at the saddle
 * from the polynomial, elsewhere from the field. */
static double at_saddle(const struct seeker *s)
{
    double d[CURVE_DIM_MAX];

    curve_slope_at(&s->b->curve, 0, 0.0, d);
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

/* The root in [lo, hi] of by_field, which changes sign: bracketed secant
 * steps. */
static double root_in(const struct seeker *s, double lo, double hi)
{
    double at_lo = by_field(s, lo), at_hi = by_field(s, hi);
    int side = 0;

    for (int i = 0; i < 100 && hi - lo > DBL_EPSILON; i++) {
        double t = hi - at_hi * (hi - lo) / (at_hi - at_lo);
        if (!(t > lo && t < hi) || i % 8 == 7)
            t = 0.5 * (lo + hi);
        const double at = by_field(s, t);
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

/* The crossing in [lo, hi], by the field; the polynomials' own slope there,
 * off as they are, would cross elsewhere. */
static struct knee locate(const struct seeker *s, double lo, double hi,
                          bool rising)
{
    const bool jumped = (by_field(s, lo) < 0.0) != rising;
    const double theta = jumped ? lo : root_in(s, lo, hi);
    const struct vec2 z = point_of(s, theta);
    const double floor = 2.0 * piece_error(s) + 4.0 * DBL_EPSILON;
    double d[CURVE_DIM_MAX];

    curve_slope_at(&s->b->curve, s->piece, theta, d);
    const double off =
        slope_uncertainty(s, z) + 2.0 * fabs((d[1] - d[0]) / d[0]);
    const double shift = off / bend(s, theta);
    return (struct knee){
        .z = z,
        .error = { fabs(d[0]) * shift + floor * (1.0 + fabs(z.x)),
                   fabs(d[1]) * shift + floor * (1.0 + fabs(z.y)) },
        .rising = rising,
    };
}

size_t knee_find(const struct planar *sys, const struct branch *b,
                 struct knee knee[], size_t room)
{
    struct seeker s = { sys, b, 0 };
    size_t n = 0;

    double at_lo = at_saddle(&s); /* the field vanishes at the saddle */
    for (; s.piece < b->curve.count; s.piece++)
        for (int i = 0; i < SAMPLES; i++) {
            const double lo = (double) i / SAMPLES;
            const double hi = (double) (i + 1) / SAMPLES;
            const double at_hi = by_field(&s, hi);
            if ((at_lo < 0.0) != (at_hi < 0.0)) {
                if (n < room)
                    knee[n] = locate(&s, lo, hi, at_lo < 0.0);
                n++;
            }
            at_lo = at_hi;
        }
    return n;
}
