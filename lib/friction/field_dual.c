/* The field with its gradient: a number is {value, d/dX, d/dY}. */
#include "field.h"

#include <math.h>

#define KIND(f) dual_##f
#define FN(f)   f
#define REAL(f) scalar_##f
#define SCALAR  double
#define VAR(w)  double w[3]
#include "scalar.h"

typedef double dual_num;
typedef double dual_real;
struct dual_ctx {
    double scale, frozen[4];
};
#define dual_anchor anchor

static inline int dual_order(const struct dual_ctx *c)
{
    (void) c;
    return 0;
}

/* The chain rule: out = value, slope * du. */
static inline void chain(double value, double slope, const double *u,
                         double *out)
{
    out[0] = value;
    out[1] = slope * u[1];
    out[2] = slope * u[2];
}

static inline void dual_linear(struct dual_ctx *c, double p, double q,
                               const double *u, double r, const double *v,
                               double *out)
{
    (void) c;
    for (int i = 0; i < 3; i++)
        out[i] = (i == 0 ? p : 0.0) + q * u[i] + (r == 0.0 ? 0.0 : r * v[i]);
}

static inline void dual_product(struct dual_ctx *c, const double *u,
                                const double *v, double *out)
{
    (void) c;
    out[0] = u[0] * v[0];
    out[1] = u[0] * v[1] + u[1] * v[0];
    out[2] = u[0] * v[2] + u[2] * v[0];
}

static inline void dual_exp(struct dual_ctx *c, double l, double s,
                            const double *u, double *out)
{
    (void) c;
    const double value = exp(l);
    chain(value, value * s, u, out);
}

static inline void dual_expm1(struct dual_ctx *c, double p, double log_p,
                              double s, const double *u, double *out)
{
    (void) c;
    const double value = scalar_expm1(p, log_p, s * u[0]);
    const double slope = copysign(exp(log_p + s * u[0]), p);
    chain(value, s * slope, u, out);
}

static inline void dual_difference(struct dual_ctx *c, double p,
                                   const double *u, const double *w,
                                   double *out)
{
    (void) c;
    const double a = scalar_exp(p, u[0]), b = scalar_exp(p, w[0]);
    out[0] = scalar_difference(p, u[0], w[0]);
    out[1] = a * u[1] - b * w[1];
    out[2] = a * u[2] - b * w[2];
}

static inline void dual_log1p_expm1(struct dual_ctx *c, double r, double s,
                                    const double *u, double *out)
{
    (void) c;
    chain(scalar_log1p_expm1(r, s, u[0]), scalar_logistic(r, s, u[0]), u, out);
}

static inline void dual_sinh(struct dual_ctx *c, const double *u, double *out)
{
    (void) c;
    chain(scalar_sinh(u[0]), scalar_cosh(u[0]), u, out);
}

static inline void dual_friction(struct dual_ctx *c, double a, double w0,
                                 double q0, const double *u, double *out)
{
    (void) c;
    chain(a * scalar_friction(w0, q0, u[0]),
          a * scalar_friction_slope(w0 + u[0]), u, out);
}

#include "field_formula.h"
#include "rate_formula.h"

void field_dual(const struct law *law, const struct anchor *at, struct vec2 z,
                struct planar_jacobian *J)
{
    struct dual_ctx c = { 0 };
    const double X[3] = { z.x, 1, 0 }, Y[3] = { z.y, 0, 1 };
    double fx[3], fy[3];

    dual_field(law, at, &c, X, Y, fx, fy);
    J->field = (struct planar_field){ { fx[0], fy[0] }, c.scale };
    J->matrix = (struct mat2){ fx[1], fx[2], fy[1], fy[2] };
}

void field_dual_rate(const struct law *law, const struct anchor *at,
                     enum block_observable which, struct vec2 z, double *rate,
                     struct vec2 *gradient)
{
    struct dual_ctx c = { 0 };
    const double X[3] = { z.x, 1, 0 }, Y[3] = { z.y, 0, 1 };
    double out[3];

    dual_rate(law, at, &c, which, 0.0, X, Y, out);
    *rate = out[0];
    *gradient = (struct vec2){ out[1], out[2] };
}
