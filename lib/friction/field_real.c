/* The field in plain double: a number is its value. */
#include "field.h"

#include <math.h>

#define KIND(f) real_##f
#define FN(f)   f
#define REAL(f) scalar_##f
#define SCALAR  double
#define VAR(w)  double w[1]
#include "scalar.h"

typedef double real_num;
typedef double real_real;
struct real_ctx {
    double scale, frozen[4];
};
#define real_anchor anchor

static inline int real_order(const struct real_ctx *c)
{
    (void) c;
    return 0;
}

static inline void real_linear(struct real_ctx *c, double p, double q,
                               const double *u, double r, const double *v,
                               double *out)
{
    (void) c;
    out[0] = p + q * u[0] + (r == 0.0 ? 0.0 : r * v[0]);
}

static inline void real_product(struct real_ctx *c, const double *u,
                                const double *v, double *out)
{
    (void) c;
    out[0] = u[0] * v[0];
}

static inline void real_exp(struct real_ctx *c, double l, double s,
                            const double *u, double *out)
{
    (void) c, (void) s, (void) u;
    out[0] = exp(l);
}

static inline void real_expm1(struct real_ctx *c, double p, double log_p,
                              double s, const double *u, double *out)
{
    (void) c;
    out[0] = scalar_expm1(p, log_p, s * u[0]);
}

static inline void real_difference(struct real_ctx *c, double p,
                                   const double *u, const double *w,
                                   double *out)
{
    (void) c;
    out[0] = scalar_difference(p, u[0], w[0]);
}

static inline void real_log1p_expm1(struct real_ctx *c, double r, double s,
                                    const double *u, double *out)
{
    (void) c;
    out[0] = scalar_log1p_expm1(r, s, u[0]);
}

static inline void real_sinh(struct real_ctx *c, const double *u, double *out)
{
    (void) c;
    out[0] = scalar_sinh(u[0]);
}

static inline void real_friction(struct real_ctx *c, double a, double w0,
                                 double q0, const double *u, double *out)
{
    (void) c;
    out[0] = a * scalar_friction(w0, q0, u[0]);
}

#include "field_formula.h"
#include "rate_formula.h"

void field_real(const struct law *law, const struct anchor *at, struct vec2 z,
                struct planar_field *f)
{
    struct real_ctx c = { 0 };

    real_field(law, at, &c, &z.x, &z.y, &f->direction.x, &f->direction.y);
    f->log_scale = c.scale;
}

double field_real_rate(const struct law *law, const struct anchor *at,
                       enum block_observable which, struct vec2 z)
{
    struct real_ctx c = { 0 };
    double rate;

    real_rate(law, at, &c, which, 0.0, &z.x, &z.y, &rate);
    return rate;
}
