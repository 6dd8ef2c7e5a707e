/* Series of the orbit and the field order by order, and the step where their
 * last two terms are as small as allowed (Jorba & Zou, Exp. Math. 14 (2005)
 * 99-117).  What we changed: a step stands only if the field at its end is the
 * derivative of the series there; what that is off by, over the order, is the
 * step's error. */
#include "taylor_orbit.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

#include "graph.h"
#include "grow.h"
#include "tolerance.h"

struct taylor_orbit taylor_orbit_at(const struct planar *system, struct vec2 z,
                                    struct vec2 side, double rtol)
{
    return (struct taylor_orbit){ .system = system,
                                  .side = side,
                                  .rtol = rtol,
                                  .order = grow_order(rtol),
                                  .curve = CURVE_EMPTY(2),
                                  .z = z };
}

/* In units of time in which the field at the start is its direction times
 * `unit`. */
struct series {
    double at[2][JET_SIZE];
    double log_scale, unit;
};

/* 1, or the power of two that makes it move by about a window, where powers of
 * how fast it is, up to the order, would all but leave the doubles. */
static double unit_of(const struct taylor_orbit *o, jet_pair x, jet_pair y)
{
    const double speed = hypot(x[0] / o->side.x, y[0] / o->side.y);
    const int e = speed > 0.0 && isfinite(speed) ? ilogb(speed) : 0;

    return abs(e) * (int) o->order > DBL_MAX_EXP - DBL_MANT_DIG ? ldexp(1.0, -e)
                                                                : 1.0;
}

static void expand(const struct taylor_orbit *o, struct series *u)
{
    struct jet_work work;
    jet_pair at[2][JET_SIZE], f[2][JET_SIZE];

    work.linear = NULL;
    work.used = 0;
    at[0][0] = JET_PAIR(o->z.x);
    at[1][0] = JET_PAIR(o->z.y);
    for (size_t k = 0; k < o->order; k++) {
        o->system->jet(o->system->ctx, &work, k, at[0], at[1], f[0], f[1]);
        if (k == 0)
            u->unit = unit_of(o, f[0][0], f[1][0]);
        for (int i = 0; i < 2; i++)
            at[i][k + 1] = f[i][k] * (u->unit * jet_inverse[k + 1]);
    }
    jet_take(o->order, at[0], 0, u->at[0]);
    jet_take(o->order, at[1], 0, u->at[1]);
    u->log_scale = work.log_scale[0];
}

static double size_of(const struct taylor_orbit *o, const struct series *u,
                      size_t k)
{
    return hypot(u->at[0][k] / o->side.x, u->at[1][k] / o->side.y);
}

/* An error of this size is allowed. */
static double allowed(const struct taylor_orbit *o, int axis)
{
    const double side = axis == 0 ? o->side.x : o->side.y;

    return o->rtol * (side + fabs(axis == 0 ? o->z.x : o->z.y));
}

/* How far the derivative at s is off the field there, in what is allowed of a
 * step so long; infinite where the field has no value. */
static double miss_at(const struct taylor_orbit *o, const struct series *u,
                      double s, struct vec2 *end)
{
    struct planar_field f;
    double most = 0.0;

    *end = (struct vec2){ jet_at(o->order, u->at[0], s),
                          jet_at(o->order, u->at[1], s) };
    o->system->field(o->system->ctx, *end, &f);
    const double scale = u->unit * exp(f.log_scale - u->log_scale);
    const double rate[] = { scale * f.direction.x, scale * f.direction.y };
    for (int i = 0; i < 2; i++) {
        const double slope = jet_slope_at(o->order, u->at[i], s);
        const double rounding = TOL_ROUNDED * (fabs(slope) + fabs(u->at[i][1]));
        const double off = s * (fabs(slope - rate[i]) - rounding) /
                           ((double) (o->order + 1) * allowed(o, i));
        if (!(off <= most))
            most = isnan(off) ? HUGE_VAL : off;
    }
    return most;
}

/* Where all but nothing bends it, it is followed by a window more, or by as
 * much as it has come: what is rounded over a step is small beside both. */
static double farthest(const struct taylor_orbit *o, const struct series *u)
{
    return (1.0 + hypot(o->z.x / o->side.x, o->z.y / o->side.y)) /
           size_of(o, u, 1);
}

static enum status store(struct taylor_orbit *o, const struct series *u,
                         double s)
{
    double *coef;
    const enum status status = curve_push(&o->curve, o->order, &coef);

    for (int i = 0; i < 2 && status == STATUS_OK; i++) {
        double power = 1.0;
        for (size_t k = 0; k <= o->order; k++, power *= s)
            coef[(size_t) i * (o->order + 1) + k] = u->at[i][k] * power;
    }
    return status;
}

enum status taylor_orbit_step(struct taylor_orbit *o)
{
    struct series u;
    struct vec2 end;
    double reach[2], s, miss, before;

    expand(o, &u);
    graph_reach(o->order, 2, (const double *const[]){ u.at[0], u.at[1] },
                (const double[]){ allowed(o, 0), allowed(o, 1) }, reach);
    s = fmin(fmin(reach[0], reach[1]), farthest(o, &u));
    o->blurred = false;
    miss = miss_at(o, &u, s, &end);
    while (miss > 1.0) {
        s *= 0.5;
        if (!(s * size_of(o, &u, 1) > 4.0 * DBL_EPSILON))
            return STATUS_NO_CONVERGENCE;
        before = miss;
        miss = miss_at(o, &u, s, &end);
        o->blurred =
            o->blurred || (before < HUGE_VAL && miss > TOL_LITTLE * before);
    }
    if (!isfinite(s) || (end.x == o->z.x && end.y == o->z.y))
        return STATUS_NO_CONVERGENCE;
    o->bent = 2.0 * s * size_of(o, &u, 2) / size_of(o, &u, 1);
    const enum status status = store(o, &u, s);
    if (status == STATUS_OK)
        o->z = end;
    return status;
}

void taylor_orbit_free(struct taylor_orbit *o)
{
    curve_free(&o->curve);
}
