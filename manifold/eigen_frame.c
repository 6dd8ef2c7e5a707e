#include "eigen_frame.h"

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
