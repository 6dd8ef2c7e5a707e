#include "eigen_drift.h"

#include <float.h>
#include <math.h>

#include "eigen_tolerance.h"
#include "tolerance.h"

static double dot(struct vec2 a, struct vec2 b)
{
    return a.x * b.x + a.y * b.y;
}

static struct vec2 across(struct vec2 t)
{
    return (struct vec2){ -t.y, t.x };
}

/* Df n in the coordinates u: map^-1 (Df (map n)). */
static struct vec2 push(struct mat2 map, struct mat2 Df, struct vec2 n)
{
    return eigen_coordinates(map, eigen_point(Df, eigen_point(map, n)));
}

/* Tangent, growth and shifts at d->u. */
static void look(struct eigen_drift *d, const struct eigen_frame *g)
{
    const struct planar *sys = g->sys;
    const struct vec2 z = eigen_point(d->map, d->u);
    struct planar_jacobian J;

    sys->jacobian(sys->ctx, z, &J);
    const struct vec2 f = eigen_coordinates(d->map, J.field.direction);
    const double speed = vec2_length(f);
    d->tangent = vec2_scale(-1.0 / speed, f);
    const struct vec2 n = across(d->tangent), An = push(d->map, J.matrix, n);
    d->growth = -dot(n, An) / speed;
    const double faster = -dot(d->tangent, An) / speed; /* d ln|f|/dn */
    for (size_t i = 0; i < g->carry->count; i++) {
        const double rate = eigen_rate(g, i, z, J.field.log_scale);
        const struct vec2 gradient =
            eigen_rate_gradient(g, i, z, J.field.log_scale);
        d->shift[i] =
            (dot(gradient, eigen_point(d->map, n)) - rate * faster) / speed;
        d->noise[i] = eigen_rate_noise(g, i, z, J.field.log_scale) / speed;
    }
}

void eigen_drift_begin(struct eigen_drift *d, const struct eigen_frame *g,
                       struct mat2 map, const double u[])
{
    *d = (struct eigen_drift){ .map = map, .u = { u[0], u[1] } };
    look(d, g);
}

void eigen_drift_turn(struct eigen_drift *d, const struct eigen_frame *g,
                      struct mat2 map, const double u[])
{
    const struct vec2 off =
        eigen_point(d->map, vec2_scale(d->normal, across(d->tangent)));

    d->map = map;
    d->u = (struct vec2){ u[0], u[1] };
    look(d, g);
    d->normal = fabs(dot(across(d->tangent), eigen_coordinates(map, off)));
}

void eigen_drift_step(struct eigen_drift *d, const struct eigen_frame *g,
                      double h, const double u[], const double error[])
{
    const struct eigen_drift old = *d;
    const double eps = TOL_ROUNDINGS_FEW * DBL_EPSILON;

    d->u = (struct vec2){ u[0], u[1] };
    look(d, g);
    const double growth = 0.5 * h * (old.growth + d->growth);
    const double ex = error[0] + eps * fabs(u[0]);
    const double ey = error[1] + eps * fabs(u[1]);
    d->normal = d->normal * exp(fmin(growth, TOL_STEP_GROWTH_MOST)) +
                fabs(d->tangent.y) * ex + fabs(d->tangent.x) * ey;
    for (size_t i = 0; i < g->carry->count; i++)
        d->total[i] += error[i + 2] + eps * fabs(u[i + 2]) +
                       h * fmax(fabs(old.shift[i]) * old.normal,
                                fabs(d->shift[i]) * d->normal);
}

double eigen_drift_of_limit(const struct eigen_drift *d, int ind)
{
    const struct vec2 t = eigen_point(d->map, d->tangent);
    const struct vec2 off =
        eigen_point(d->map, vec2_scale(d->normal, across(d->tangent)));

    return ind == 0 ? fabs(off.y - t.y / t.x * off.x)
                    : fabs(off.x - t.x / t.y * off.y);
}

double eigen_drift_of_point(const struct eigen_drift *d)
{
    return fmin(eigen_drift_of_limit(d, 0), eigen_drift_of_limit(d, 1));
}

double eigen_drift_of_piece(const struct eigen_drift *before,
                            const struct eigen_drift *after,
                            const double defect[])
{
    struct eigen_drift within = *after;

    within.normal +=
        fabs(after->tangent.y) * defect[0] + fabs(after->tangent.x) * defect[1];
    return fmax(eigen_drift_of_point(before), eigen_drift_of_point(&within));
}
