/*
 * field_lanes.h -- the field of several points side by side (lanes.h; define
 * LANES before).  A number is the values of its lanes: each is what
 * the tape of the law makes of its point, to rounding.  Where scalar.h branches
 * on values, the rarer branch is skipped unless a lane needs it.
 */
#ifndef FRICTION_FIELD_LANES_H
#define FRICTION_FIELD_LANES_H

#include <stdbool.h>

#include "anchor.h"
#include "lanes.h"

#define KIND(f) many_##f
#define REAL(f) many_##f
#define VAR(w)  lanes w[1]

typedef lanes many_num;
typedef lanes many_real;
struct many_ctx {
    lanes scale, frozen[4];
};
#define many_anchor anchor

#define many_size(u)        lanes_size(u)
#define many_power(u)       lanes_exp(u)
#define many_ln(u)          lanes_ln(u)
#define many_larger(u, w)   lanes_larger(u, w)
#define many_at_least(p, u) lanes_larger(u, LANES_OF(p))
#define many_choose(u, p, q, r)                                                \
    lanes_less(u, LANES_OF(p), LANES_OF(q), LANES_OF(r))
#define many_linear(c, p, q, u, r, w, out)                                     \
    ((void) (c), (out)[0] = LANES_OF(p) + LANES_OF(q) * (u)[0] +               \
                            _Generic((r), lanes                                \
                                     : many_times, default                     \
                                     : many_times_plain)(r, (w)[0]))
#define many_exp(c, l, s, u, out)                                              \
    ((void) (c), (out)[0] = lanes_exp(LANES_OF(l)))
#define many_expm1(c, p, log_p, s, u, out)                                     \
    ((void) (c),                                                               \
     (out)[0] = many_growth(LANES_OF(p), LANES_OF(log_p), (s) * (u)[0]))

static inline int many_order(const struct many_ctx *c)
{
    (void) c;
    return 0;
}

static inline lanes many_times(lanes r, lanes w)
{
    return r * w;
}

static inline lanes many_times_plain(double r, lanes w)
{
    return r == 0.0 ? LANES_OF(0.0) : r * w;
}

static inline void many_product(struct many_ctx *c, const lanes *u,
                                const lanes *w, lanes *out)
{
    (void) c;
    out[0] = u[0] * w[0];
}

/* p (e^u - 1), also where e^u overflows. */
static inline lanes many_growth(lanes p, lanes log_p, lanes u)
{
    const lanes near = p * lanes_em1(u);

    if (!lanes_any_less(LANES_OF(1.0), u))
        return near;
    const lanes far = lanes_signed(lanes_exp(log_p + u), p) - p;
    return lanes_less(LANES_OF(1.0), u, far, near);
}

static inline void many_difference(struct many_ctx *c, double p, const lanes *u,
                                   const lanes *w, lanes *out)
{
    const lanes half = lanes_exp(0.5 * lanes_larger(u[0], w[0]));
    const lanes less = lanes_em1(-lanes_size(u[0] - w[0]));

    (void) c;
    out[0] = p * half * half * lanes_less(w[0], u[0], -less, less);
}

static inline void many_log1p_expm1(struct many_ctx *c, double r, double s,
                                    const lanes *u, lanes *out)
{
    const lanes up = lanes_em1(u[0]), change = r * up;
    const lanes all = s + r * (up + 1.0);

    (void) c;
    out[0] = u[0];
    if (s == 0.0)
        return;
    out[0] = lanes_ln_near(
        lanes_less(change, LANES_OF(-0.5), all, 1.0 + change), change);
    const lanes far = LANES_OF(700.0);
    if (lanes_any_less(far, u[0]))
        out[0] = lanes_less(far, u[0], u[0] + log(r), out[0]);
}

static inline void many_sinh(struct many_ctx *c, const lanes *u, lanes *out)
{
    (void) c;
    out[0] = lanes_signed(0.5 * lanes_em1(-2.0 * lanes_size(u[0])), u[0]);
}

/* asinh(e^w/2) for any w. */
static inline lanes many_asinh_exp(lanes w)
{
    const lanes t = 0.5 * lanes_exp(w), root = lanes_root(1.0 + t * t);
    const lanes near = lanes_ln1p(t + t * t / (1.0 + root));
    const lanes q = 4.0 * lanes_exp(-2.0 * w);
    const lanes far = w + lanes_ln1p(0.5 * (lanes_root(1.0 + q) - 1.0));

    return lanes_less(LANES_OF(1.0), w, far, near);
}

/* scalar_friction where e^w0 or e^(w0 + u) is not large. */
static inline lanes many_slight_friction(double w0, lanes u)
{
    const double t0 = 0.5 * exp(w0), root0 = sqrt(1.0 + t0 * t0);
    const lanes e = lanes_exp(u), t = t0 * e;
    const lanes s =
        t0 * lanes_em1(2.0 * u) / (e * root0 + lanes_root(1.0 + t * t));
    const lanes size = lanes_size(s), root = lanes_root(1.0 + size * size);
    const lanes near =
        lanes_signed(lanes_ln1p(size + size * size / (1.0 + root)), s);
    const lanes far = many_asinh_exp(w0 + u) - many_asinh_exp(LANES_OF(w0));

    return lanes_less(lanes_size(u), LANES_OF(1.0), near, far);
}

/* scalar_friction where both are. */
static inline lanes many_fair_friction(double w0, double q0, lanes u)
{
    const double s0 = sqrt(1.0 + q0);
    const lanes q = 4.0 * lanes_exp(-2.0 * (w0 + u));
    const lanes part = lanes_em1(-2.0 * lanes_size(u));
    const lanes dq = lanes_less(u, LANES_OF(0.0), -q, LANES_OF(q0)) * part;

    return u + lanes_ln1p(dq / ((lanes_root(1.0 + q) + s0) * (1.0 + s0)));
}

/* Where both are huge, beyond 2^59, the asinh is the logarithm. */
static inline void many_friction(struct many_ctx *c, double a, double w0,
                                 double q0, const lanes *u, lanes *out)
{
    const lanes fair = LANES_OF(0.7), huge = LANES_OF(20.5);
    const lanes least = lanes_smaller(w0 + u[0], LANES_OF(w0));

    (void) c;
    out[0] = a * u[0];
    if (lanes_any_less(least, huge))
        out[0] = a * many_fair_friction(w0, q0, u[0]);
    if (lanes_any_less(least, fair))
        out[0] =
            lanes_less(least, fair, a * many_slight_friction(w0, u[0]), out[0]);
}

#include "field_formula.h"

#endif
