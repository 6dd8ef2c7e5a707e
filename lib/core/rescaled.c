/* With f = d e^L, N = sqrt(kappa^2 + |f|^2), Df = M e^L and p = Df^T f / N^2:
 *     dz/dtau = f / N          d(f/N) = (Df - f p^T) / N
 *     dt/dtau = 1 / N          d(1/N) = -p / N
 *     dq/dtau = r / N          d(r/N) = (grad r - r p) / N.
 * All are ratios of like powers of e^L, so numerators and N are scaled by
 * e^-L where L > 0: only what is truly negligible underflows. */
#include "rescaled.h"

#include <math.h>

#include "tolerance.h"

/* The field, its clock and the common factor: f = d / a, N = n / a. */
struct scaled {
    struct vec2 d;
    double a, n;
    double unit; /* d = direction * unit */
};

/* A scale beside which e^-L has few digits, or none, is lent to a direction
 * that is small, as where a huge rate of psi is all but balanced. */
static double lent(const struct planar_field *f)
{
    const double size = fmax(fabs(f->direction.x), fabs(f->direction.y));

    return f->log_scale > TOL_RESCALED_FAR && size > 0.0 && size < 1.0
               ? fmin(-log(size), TOL_RESCALED_FAR)
               : 0.0;
}

static struct scaled scale(const struct planar_field *f, double kappa)
{
    const bool fast = f->log_scale > 0.0;
    const double loan = lent(f);
    const double unit = fast ? exp(loan) : exp(f->log_scale);
    const double a = fast ? exp(loan - f->log_scale) : 1.0;
    const struct vec2 d = vec2_scale(unit, f->direction);
    const double slow = kappa * a;
    const double plain = sqrt(slow * slow + d.x * d.x + d.y * d.y);

    /* Outside this range a square may have over- or underflowed. */
    if (plain > 1e-140 && plain < 1e140)
        return (struct scaled){ d, a, plain, unit };
    const double n = hypot(slow, hypot(d.x, d.y));
    if (n > 0.0 || n != n)
        return (struct scaled){ d, a, n, unit };
    return (struct scaled){ { 0.0, 0.0 }, 1.0, kappa, unit }; /* f = 0 */
}

static void plane(const void *ctx, struct vec2 z, double du[])
{
    const struct rescaled *r = ctx;
    struct planar_field f;

    r->system->field(r->system->ctx, z, &f);
    const struct scaled s = scale(&f, r->kappa);
    du[0] = s.d.x / s.n;
    du[1] = s.d.y / s.n;
    du[2] = s.a / s.n;
}

/* dt/dtau is there already. */
static void integrals(const void *ctx, struct vec2 z, double du[])
{
    const struct rescaled *r = ctx;
    const struct planar *sys = r->system;
    double rate;

    for (size_t i = 0; i < r->observables; i++) {
        sys->rate_gradient(sys->ctx, i, z, &rate, NULL);
        du[3 + i] = rate * du[2];
    }
}

void rescaled_linear(const struct rescaled *r, struct vec2 z,
                     struct cascade_linear *out)
{
    const struct planar *sys = r->system;
    struct planar_jacobian J;
    struct vec2 g;
    double rate;

    sys->jacobian(sys->ctx, z, &J);
    const struct scaled s = scale(&J.field, r->kappa);
    const double w = s.unit / s.n;
    const struct mat2 M = { w * J.matrix.xx, w * J.matrix.xy, w * J.matrix.yx,
                            w * J.matrix.yy };
    const double x = s.d.x / s.n, y = s.d.y / s.n, t = s.a / s.n;
    const struct vec2 p = { M.xx * x + M.yx * y, M.xy * x + M.yy * y };

    out->du[0] = x;
    out->du[1] = y;
    out->du[2] = t;
    out->slope[0] = (struct vec2){ M.xx - x * p.x, M.xy - x * p.y };
    out->slope[1] = (struct vec2){ M.yx - y * p.x, M.yy - y * p.y };
    out->slope[2] = vec2_scale(-t, p);
    for (size_t i = 0; i < r->observables; i++) {
        sys->rate_gradient(sys->ctx, i, z, &rate, &g);
        out->du[3 + i] = rate * t;
        out->slope[3 + i] =
            vec2_scale(t, (struct vec2){ g.x - rate * p.x, g.y - rate * p.y });
    }
}

double rescaled_rate(const struct cascade_linear *l)
{
    const struct vec2 p = vec2_scale(-1.0 / l->du[2], l->slope[2]);
    const struct vec2 x = vec2_add(l->slope[0], vec2_scale(l->du[0], p));
    const struct vec2 y = vec2_add(l->slope[1], vec2_scale(l->du[1], p));

    return fmax(fmax(fabs(x.x), fabs(x.y)), fmax(fabs(y.x), fabs(y.y))) /
           l->du[2];
}

struct cascade rescaled_cascade(const struct rescaled *r)
{
    return (struct cascade){ 3 + r->observables, plane, integrals, r };
}
