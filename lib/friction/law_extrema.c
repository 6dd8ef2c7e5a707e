/* The extrema of mu_ss are where its slope changes sign: looked for in steps of
 * an e-fold of v, between steps where the slope is least, and settled in 113
 * bits. */
#include <float.h>
#include <math.h>

#include "friction_tolerance.h"
#include "law_typed.h"
#include "newton.h"
#include "quad.h"
#include "tolerance.h"

/* A law and a material in both kinds of numbers. */
struct curve {
    struct law_long rough;
    struct law_quad fine;
};

static bool is_there(struct curve *c, long double x)
{
    return isfinite(law_long_steady(&c->rough, x, LAW_AT_Y)) &&
           isfinite(law_long_steady(&c->rough, x, LAW_AT_MU));
}

/* The last x from `in`, where mu_ss is, towards `out`. */
static long double last_there(struct curve *c, long double in, long double out)
{
    if (is_there(c, out))
        return out;
    for (int i = 0; i < 80; i++) {
        const long double mid = (in + out) / 2;
        *(is_there(c, mid) ? &in : &out) = mid;
    }
    return in;
}

static void range(struct curve *c, long double *lo, long double *hi)
{
    const long double far = (long double) LN_RANGE;
    long double in = 0;

    for (int i = 1; i < 40 && !is_there(c, in); i++)
        in = (i % 2 ? -1 : 1) * (long double) i; /* 0, -1, 2, -3, ... */
    *lo = in;
    *hi = in;
    for (long double step = 1; step < 2 * far; step *= 2) {
        if (is_there(c, fmaxl(in - step, -far)))
            *lo = fmaxl(in - step, -far);
        if (is_there(c, fminl(in + step, far)))
            *hi = fminl(in + step, far);
    }
    *lo = last_there(c, *lo, fmaxl(-far, in - 2 * (in - *lo) - 1));
    *hi = last_there(c, *hi, fminl(far, in + 2 * (*hi - in) + 1));
}

void law_typed_range(const struct law *law, const struct material *m,
                     long double *lo, long double *hi)
{
    struct curve c;

    law_long_init(&c.rough, law, m, 0);
    range(&c, lo, hi);
}

/* d mu_ss/dx, soon */
static long double rough(struct curve *c, long double x)
{
    return law_long_along(&c->rough, x, LAW_AT_MU);
}

static quad fine(struct curve *c, long double x)
{
    return law_quad_along(&c->fine, x, LAW_AT_MU);
}

/* -1, 1, or 0 where it is none to all digits */
static int sign_of(quad slope)
{
    const quad least = TOL_SLOPE_LEAST;

    return (slope > least) - (slope < -least);
}

struct extrema {
    struct curve *c;
    long double *x;
    size_t n;
};

/* Whether the slope has other signs at both ends; *at_lo and *at_hi. */
static bool turns(struct extrema *e, long double lo, long double hi,
                  quad *at_lo, quad *at_hi)
{
    *at_lo = fine(e->c, lo);
    *at_hi = fine(e->c, hi);
    return sign_of(*at_lo) * sign_of(*at_hi) < 0;
}

static long double rough_of(const void *ctx, long double x)
{
    const struct extrema *e = ctx;

    return rough(e->c, x);
}

/* What the rough slope says of where in lo .. hi it is. */
static void narrow(struct extrema *e, long double *lo, long double *hi)
{
    const long double aside = (long double) TOL_EXTREMUM_ASIDE;
    struct newton_root_long root;

    if (newton_find_long(rough_of, e, *lo, *hi, aside, &root) != STATUS_OK)
        return;
    *lo = fmaxl(*lo, root.x - aside);
    *hi = fminl(*hi, root.x + aside);
}

/* By false position, the older end's slope halved (Illinois); false where there
 * is none, for the slope has one sign at both ends. */
static bool between(struct extrema *e, long double lo, long double hi)
{
    long double near = lo, far = hi;
    quad at_lo, at_hi;

    if (e->n == 4)
        return true;
    narrow(e, &near, &far);
    if (turns(e, near, far, &at_lo, &at_hi)) {
        lo = near;
        hi = far;
    } else if (!turns(e, lo, hi, &at_lo, &at_hi)) {
        return false;
    }
    long double x = lo, before = hi;
    for (int i = 0; i < 60 && fabsl(x - before) > LDBL_EPSILON * (1 + fabsl(x));
         i++) {
        before = x;
        x = hi - (long double) (at_hi / (at_hi - at_lo)) * (hi - lo);
        const quad at_x = fine(e->c, x);
        if ((at_x > 0) == (at_hi > 0)) {
            at_lo /= 2;
        } else {
            lo = hi;
            at_lo = at_hi;
        }
        hi = x;
        at_hi = at_x;
    }
    e->x[e->n++] = x;
    return true;
}

/* Whether the slope, of one sign at lo and hi, has the other between. */
static bool dips(const struct extrema *e, long double lo, long double hi,
                 bool rises, long double *at)
{
    const long double sign = rises ? 1 : -1;

    for (int i = 0; i < 60; i++) {
        const long double s = lo + (hi - lo) / 3, t = hi - (hi - lo) / 3;
        if (sign * rough(e->c, s) < sign * rough(e->c, t))
            hi = t;
        else
            lo = s;
    }
    *at = (lo + hi) / 2;
    return sign_of(fine(e->c, *at)) == (rises ? -1 : 1);
}

/* In steps of at most an e-fold from lo to hi. */
static void look_between(struct extrema *e, long double lo, long double hi)
{
    const int steps = (int) ceill(hi - lo);
    const long double h = (hi - lo) / (long double) steps;
    const long double off = TOL_EXTREMUM_REACH;
    long double at, slope[3] = { 0, 0, 0 };

    for (int i = 0; i <= steps; i++) {
        const long double here = lo + h * i;
        slope[2] = rough(e->c, here);
        if (i > 0 && (slope[1] > 0) != (slope[2] > 0)) {
            if (!between(e, here - h, here)) /* a sign at its ends is wrong */
                (void) between(e, here - h - off, here + off);
        } else if (i > 1 && (slope[0] > 0) == (slope[1] > 0) &&
                   fabsl(slope[1]) < fabsl(slope[0]) &&
                   fabsl(slope[1]) < fabsl(slope[2]) &&
                   dips(e, here - 2 * h, here, slope[1] > 0, &at)) {
            (void) between(e, here - 2 * h, at);
            (void) between(e, at, here);
        }
        slope[0] = slope[1];
        slope[1] = slope[2];
    }
}

/* Whether mu_ss is not a straight line of x around a step of three e-folds: its
 * second difference there is (3)^2 mu'' of an extremum with slopes that tell.
 */
static bool bends(const long double mu[3])
{
    const long double bend = mu[0] - 2 * mu[1] + mu[2];

    return fabsl(bend) > (long double) TOL_ROUNDED * (1 + fabsl(mu[1]));
}

size_t law_typed_extrema(const struct law *law, const struct material *m,
                         long double x[4])
{
    struct curve c;
    enum { STEP = 3 };
    const long double edge = TOL_EXTREMUM_REACH;
    struct extrema e = { &c, x, 0 };
    long double lo, hi, done, from = NAN, mu[3] = { 0, 0, 0 };

    law_long_init(&c.rough, law, m, 0);
    law_quad_init(&c.fine, law, m, 0);
    range(&c, &lo, &hi);
    done = lo + edge;
    const int steps = (int) ((hi - lo) / STEP);
    for (int i = 0; i <= steps; i++) {
        const long double here = lo + STEP * i;
        mu[0] = mu[1];
        mu[1] = mu[2];
        mu[2] = law_long_steady(&c.rough, here, LAW_AT_MU);
        const bool bent = i > 1 && bends(mu);
        if (bent && isnan(from))
            from = fmaxl(done, here - 3 * STEP);
        if (isnan(from) || (bent && i < steps))
            continue;
        done = fminl(hi - edge, here + STEP);
        look_between(&e, from, done);
        from = NAN;
    }
    return e.n;
}
