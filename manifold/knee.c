/*
 * Knees of a branch.  Crossings are bracketed on the stored polynomials; each
 * is located twice, on the polynomial's derivative and on the field's slope
 * along the polynomial, and the difference of the two is the error.
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

/* The crossing in [lo, hi], by both routes. */
static struct knee locate(const struct seeker *s, double lo, double hi,
                          bool rising)
{
    const double first = root_in(by_polynomial, s, lo, hi);
    const bool both = (by_field(s, lo) < 0.0) != (by_field(s, hi) < 0.0);
    const double second = both ? root_in(by_field, s, lo, hi) : first;
    const struct vec2 p = point_of(s, first), q = point_of(s, second);
    const struct vec2 origin = s->sys->origin;
    /* how far the root moves when the slope is off by a rounding error */
    const double span = fabs(by_field(s, hi) - by_field(s, lo)) / (hi - lo);
    double d[CURVE_DIM_MAX];
    curve_slope_at(&s->b->curve, s->piece, second, d);
    const double noise =
        64.0 * DBL_EPSILON * fabs(d[0]) / span * (1.0 + fabs(q.x) + fabs(q.y));
    const double shift = both ? noise : noise + fabs(hi - lo);

    return (struct knee){
        .z = q,
        .error = { fabs(p.x - q.x) + fabs(d[0]) * shift +
                       4.0 * DBL_EPSILON * (fabs(q.x) + fabs(origin.x)),
                   fabs(p.y - q.y) + fabs(d[1]) * shift +
                       4.0 * DBL_EPSILON * (fabs(q.y) + fabs(origin.y)) },
        .rising = rising,
    };
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
            if ((at_lo < 0.0) != (at_hi < 0.0)) {
                if (n < room)
                    knee[n] = locate(&s, lo, hi, at_lo < 0.0);
                n++;
            }
            lo = hi;
            at_lo = at_hi;
        }
    }
    return n;
}
