#include "zero.h"

#include <float.h>
#include <math.h>

#include "newton.h"
#include "tolerance.h"
#include "window.h"

/* What zero_value makes of a component. */
static double zero_sign_safe(double c)
{
    return c == 0.0 ? copysign(DBL_TRUE_MIN, c) : c;
}

/* The offset from the system's origin, pushed back into the domain. */
static struct vec2 offset(const struct planar *system, struct box box,
                          struct vec2 u)
{
    const struct box d = system->domain;
    struct vec2 z = window_mix(box, u);

    z.x = fmin(fmax(z.x, d.lo.x), d.hi.x);
    z.y = fmin(fmax(z.y, d.lo.y), d.hi.y);
    return vec2_sub(z, system->origin);
}

static double plain_value(const struct zero *q, struct vec2 u)
{
    struct planar_field f;

    q->system->field(q->system->ctx, offset(q->system, q->box, u), &f);
    return vec2_part(f.direction, q->which);
}

/* Never 0 and never overflowing: where the component is 0, or has underflowed,
 * the smallest number of its sign.  Constant beyond the domain. */
static double zero_value(struct zero *q, struct vec2 u)
{
    q->calls++;
    return zero_sign_safe(plain_value(q, u));
}

struct segment {
    const struct zero *q;
    struct vec2 a, step;
};

static struct vec2 along(const struct segment *c, double s)
{
    return vec2_add(c->a, vec2_scale(s, c->step));
}

static double value_along(const void *ctx, double s)
{
    const struct segment *c = ctx;
    return zero_sign_safe(plain_value(c->q, along(c, s)));
}

/* Whether the sign change at u is more than one between some digits and none:
 * on both sides, either there are digits or there are not. */
static bool is_genuine(struct zero *q, struct vec2 u, struct vec2 across)
{
    const double scale = TOL_TOUCH / vec2_length(across);
    const struct vec2 aside = vec2_scale(scale, across);

    q->calls++;
    if (fabs(plain_value(q, u)) >= DBL_MIN)
        return true;
    q->calls += 2;
    const double lo = plain_value(q, vec2_sub(u, aside));
    const double hi = plain_value(q, vec2_add(u, aside));
    return (lo == 0.0) == (hi == 0.0) && signbit(lo) != signbit(hi);
}

bool zero_between(struct zero *q, struct vec2 a, struct vec2 b, struct vec2 *u)
{
    const struct segment line = { q, a, vec2_sub(b, a) };
    struct newton_root root;

    if (newton_find(value_along, &line, 0.0, 1.0,
                    0.5 * DBL_EPSILON / vec2_length(line.step),
                    &root) != STATUS_OK)
        return false;
    q->calls += root.calls;
    const struct vec2 at = along(&line, root.x);
    if (!is_genuine(q, at, line.step))
        return false;
    *u = at;
    return true;
}

/* Whether signs differ at `width` from u on both sides; false for a NaN. */
static bool differs(struct zero *q, struct vec2 u, struct vec2 across,
                    double width)
{
    const struct vec2 aside = vec2_scale(width, across);
    const double lo = zero_value(q, vec2_sub(u, aside));
    const double hi = zero_value(q, vec2_add(u, aside));

    return (lo < 0.0 && hi > 0.0) || (lo > 0.0 && hi < 0.0);
}

bool zero_within(struct zero *q, struct vec2 u, struct vec2 across,
                 double narrow, double reach, double *width)
{
    for (double w = fmin(narrow, reach);; w = fmin(8.0 * w, reach)) {
        *width = w;
        if (differs(q, u, across, w))
            return true;
        if (!(w < reach))
            return false;
    }
}

bool zero_near(struct zero *q, struct vec2 u, struct vec2 across, double narrow,
               double reach, struct vec2 *out)
{
    double width;

    if (!zero_within(q, u, across, narrow, reach, &width))
        return false;
    const struct vec2 aside = vec2_scale(width, across);
    return zero_between(q, vec2_sub(u, aside), vec2_add(u, aside), out);
}

/* The gradient in u, up to a factor; false where it has too few digits. */
static bool gradient(struct zero *q, struct vec2 u, struct vec2 *g)
{
    const struct vec2 size = vec2_sub(q->box.hi, q->box.lo);
    struct planar_jacobian J;

    q->calls++;
    q->system->jacobian(q->system->ctx, offset(q->system, q->box, u), &J);
    const struct mat2 A = J.matrix;
    g->x = size.x * (q->which == 0 ? A.xx : A.yx);
    g->y = size.y * (q->which == 0 ? A.xy : A.yy);
    const double big = fmax(fabs(g->x), fabs(g->y));
    if (!(big > DBL_MIN / DBL_EPSILON && isfinite(g->x) && isfinite(g->y)))
        return false;
    *g = vec2_scale(1.0 / big, *g);
    return true;
}

bool zero_tangent(struct zero *q, struct vec2 u, struct vec2 along_,
                  struct vec2 *tangent)
{
    struct vec2 g, t;

    if (gradient(q, u, &g)) {
        t = (struct vec2){ -g.y, g.x };
    } else {
        const struct vec2 next = vec2_add(u, vec2_scale(TOL_ASIDE, along_));
        const struct vec2 across = { -along_.y, along_.x };
        struct vec2 near;
        if (!zero_near(q, next, across, TOL_ASIDE, 64.0 * TOL_ASIDE, &near))
            return false;
        t = vec2_sub(near, u);
    }
    const double length = vec2_length(t);
    if (!(length > 0.0))
        return false;
    const double dot = t.x * along_.x + t.y * along_.y;
    *tangent = vec2_scale(copysign(1.0 / length, dot), t);
    return true;
}
