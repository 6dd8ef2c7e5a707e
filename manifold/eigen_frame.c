#include "eigen_frame.h"

#include <float.h>
#include <math.h>

static struct vec2 column(const struct equilibrium *e, int which)
{
    const struct vec2 v = mat2_eigenvector(e->matrix, e->scaled[which]);
    return vec2_scale(1.0 / fmax(fabs(v.x), fabs(v.y)), v);
}

struct mat2 eigen_basis(const struct equilibrium *e)
{
    const struct vec2 u = column(e, 0), v = column(e, 1);
    return (struct mat2){ u.x, v.x, u.y, v.y };
}

struct vec2 eigen_point(struct mat2 P, struct vec2 W)
{
    return (struct vec2){ P.xx * W.x + P.xy * W.y, P.yx * W.x + P.yy * W.y };
}

struct vec2 eigen_coordinates(struct mat2 P, struct vec2 z)
{
    const double det = mat2_det(P);
    return (struct vec2){ (P.yy * z.x - P.xy * z.y) / det,
                          (P.xx * z.y - P.yx * z.x) / det };
}

struct eigen_frame eigen_frame_at(const struct planar *sys,
                                  const struct equilibrium *e,
                                  const struct carry *carry)
{
    const struct vec2 saddle = { 0.0, 0.0 };
    const struct mat2 P = eigen_basis(e);
    struct eigen_frame g = { .sys = sys,
                             .carry = carry,
                             .basis = P,
                             .ratio = e->scaled[1] / e->scaled[0] };

    g.thin = P.xx == 0.0 ? 1.0 : fmin(fabs(P.xx / P.xy), 1.0);
    for (size_t i = 0; i < carry->count; i++)
        g.converges[i] = eigen_rate(&g, i, saddle, 0.0) == 0.0;
    return g;
}

struct vec2 eigen_velocity(const struct eigen_frame *g, struct vec2 W,
                           double *log_scale)
{
    struct planar_field f;

    g->sys->field(g->sys->ctx, eigen_point(g->basis, W), &f);
    *log_scale = f.log_scale;
    return eigen_coordinates(g->basis, f.direction);
}

double eigen_rate(const struct eigen_frame *g, size_t i, struct vec2 z,
                  double log_scale)
{
    const int which = g->carry->which[i];
    double rate = 1.0;

    if (which != CARRY_TIME)
        g->sys->rate_gradient(g->sys->ctx, (size_t) which, z, &rate, NULL);
    return rate * exp(-log_scale);
}

struct vec2 eigen_rate_gradient(const struct eigen_frame *g, size_t i,
                                struct vec2 z, double log_scale)
{
    const int which = g->carry->which[i];
    struct vec2 gradient = { 0.0, 0.0 };
    double rate;

    if (which != CARRY_TIME)
        g->sys->rate_gradient(g->sys->ctx, (size_t) which, z, &rate, &gradient);
    return vec2_scale(exp(-log_scale), gradient);
}

double eigen_rate_noise(const struct eigen_frame *g, size_t i, struct vec2 z,
                        double log_scale)
{
    const struct vec2 slope = eigen_rate_gradient(g, i, z, log_scale);
    return DBL_EPSILON * (fabs(slope.x * z.x) + fabs(slope.y * z.y));
}
