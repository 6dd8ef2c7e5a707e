#include "plane.h"

#include <math.h>

struct vec2 vec2_spread(double shift, double t)
{
    const double x = shift + 0.7548776662466927 * t;
    const double y = shift + 0.5698402909980532 * t;

    return (struct vec2){ x - floor(x), y - floor(y) };
}

double vec2_cross(struct vec2 u, struct vec2 v)
{
    return u.x * v.y - u.y * v.x;
}

double vec2_length(struct vec2 v)
{
    return hypot(v.x, v.y);
}

double mat2_det(struct mat2 A)
{
    const double w = A.xy * A.yx;
    const double e = fma(-A.xy, A.yx, w); /* e = w - xy*yx, exactly */
    const double f = fma(A.xx, A.yy, -w);
    return f + e;
}

/* Of a matrix whose products neither over- nor underflow. */
static struct eigen2 eigenvalues(struct mat2 A)
{
    const double m = 0.5 * (A.xx + A.yy), d = 0.5 * (A.xx - A.yy);
    const double radicand = fma(d, d, A.xy * A.yx);

    if (radicand < 0.0)
        return (struct eigen2){ { m, m }, sqrt(-radicand) };
    const double far = m + copysign(sqrt(radicand), m);
    const double near = far == 0.0 ? 0.0 : mat2_det(A) / far;
    return (struct eigen2){ { fmin(far, near), fmax(far, near) }, 0.0 };
}

struct eigen2 mat2_eigenvalues(struct mat2 A)
{
    const double size =
        fmax(fmax(fabs(A.xx), fabs(A.xy)), fmax(fabs(A.yx), fabs(A.yy)));

    if (!(size > 0.0 && isfinite(size)))
        return eigenvalues(A);
    const int e = -ilogb(size);
    const struct mat2 B = { ldexp(A.xx, e), ldexp(A.xy, e), ldexp(A.yx, e),
                            ldexp(A.yy, e) };
    const struct eigen2 of_b = eigenvalues(B);
    return (struct eigen2){ { ldexp(of_b.re[0], -e), ldexp(of_b.re[1], -e) },
                            ldexp(of_b.im, -e) };
}

struct vec2 mat2_eigenvector(struct mat2 A, double lambda)
{
    const double p = A.xx - lambda, q = A.yy - lambda;
    struct vec2 v = fabs(q) >= fabs(p) ? (struct vec2){ q, -A.yx }
                                       : (struct vec2){ -A.xy, p };
    if (v.x == 0.0 && v.y == 0.0) /* a triangular matrix, or a multiple of 1 */
        v = A.xy == 0.0 && A.yx != 0.0 ? (struct vec2){ 0.0, 1.0 }
                                       : (struct vec2){ 1.0, 0.0 };
    const double length = vec2_length(v);
    const double sign = v.x < 0.0 || (v.x == 0.0 && v.y < 0.0) ? -1.0 : 1.0;
    return vec2_scale(sign / length, v);
}
