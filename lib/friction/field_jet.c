/* The field along a curve: a number is its Taylor series, one coefficient a
 * call (core/jet.h).  Helper series take slots of their own. */
#include "field.h"

#include <math.h>

#define KIND(f) jet_##f
#define FN(f)   f
#define REAL(f) scalar_##f
#define SCALAR  double
#define VAR(w)  double *w = jet_slot(c->work)
#include "scalar.h"

typedef double jet_num;
typedef double jet_real;
struct jet_ctx {
    struct jet_work *work;
    size_t k;
    double scale;
    double *frozen;
};
#define jet_anchor anchor

static inline size_t jet_order(const struct jet_ctx *c)
{
    return c->k;
}

static inline void jet_linear(struct jet_ctx *c, double p, double q,
                              const double *u, double r, const double *v,
                              double *out)
{
    const size_t k = c->k;

    out[k] = (k == 0 ? p : 0.0) + q * u[k] + (r == 0.0 ? 0.0 : r * v[k]);
}

static inline void jet_times(struct jet_ctx *c, const double *u,
                             const double *v, double *out)
{
    out[c->k] = jet_product(c->k, u, v);
}

/* w' = s u' w */
static inline void jet_exp(struct jet_ctx *c, double l, double s,
                           const double *u, double *out)
{
    const size_t k = c->k;

    out[k] =
        k == 0 ? exp(l) : s * jet_chain(c->work, k, u, out) * jet_inverse[k];
}

/* w' = s u' (w + p), with e = w + p kept as a series of its own */
static inline void jet_expm1(struct jet_ctx *c, double p, double log_p,
                             double s, const double *u, double *out)
{
    VAR(e);
    const size_t k = c->k;

    if (k == 0) {
        out[0] = scalar_expm1(p, log_p, s * u[0]);
        e[0] = copysign(exp(log_p + s * u[0]), p);
        return;
    }
    out[k] = e[k] = s * jet_chain(c->work, k, u, e) * jet_inverse[k];
}

/* p e^u and p e^w as series of their own */
static inline void jet_difference(struct jet_ctx *c, double p, const double *u,
                                  const double *w, double *out)
{
    VAR(eu);
    VAR(ew);
    const size_t k = c->k;

    if (k == 0) {
        out[0] = scalar_difference(p, u[0], w[0]);
        eu[0] = scalar_exp(p, u[0]);
        ew[0] = scalar_exp(p, w[0]);
        return;
    }
    eu[k] = jet_chain(c->work, k, u, eu) * jet_inverse[k];
    ew[k] = jet_chain(c->work, k, w, ew) * jet_inverse[k];
    out[k] = eu[k] - ew[k];
}

/* w' = p u' with the logistic p, p' = p (1 - p) u' */
static inline void jet_log1p_expm1(struct jet_ctx *c, double r, double s,
                                   const double *u, double *out)
{
    VAR(p);
    VAR(slope);
    const size_t k = c->k;

    if (s == 0.0) {
        out[k] = u[k];
        return;
    }
    if (k == 0) {
        out[0] = scalar_log1p_expm1(r, s, u[0]);
        p[0] = scalar_logistic(r, s, u[0]);
        slope[0] = p[0] * scalar_logistic_rest(r, s, u[0]);
        return;
    }
    out[k] = jet_chain(c->work, k, u, p) * jet_inverse[k];
    p[k] = jet_chain(c->work, k, u, slope) * jet_inverse[k];
    slope[k] = p[k] - jet_square(k, p);
}

/* s' = c u', c' = s u'; as e^(2u) - 1 over e^u, coefficient k would lose a
 * factor 3^k where u is steep */
static inline void jet_sinh(struct jet_ctx *c, const double *u, double *out)
{
    VAR(even);
    const size_t k = c->k;

    if (k == 0) {
        out[0] = scalar_sinh(u[0]);
        even[0] = scalar_cosh(u[0]);
        return;
    }
    out[k] = jet_chain(c->work, k, u, even) * jet_inverse[k];
    even[k] = jet_chain(c->work, k, u, out) * jet_inverse[k];
}

/* m = asinh(e^w/2): m' = t w', t = tanh m, t' = t b w', b = 1 - t^2 */
static inline void jet_friction(struct jet_ctx *c, double a, double w0,
                                double q0, const double *u, double *out)
{
    VAR(t);
    VAR(b);
    VAR(tb);
    const size_t k = c->k;

    if (k == 0) {
        out[0] = a * scalar_friction(w0, q0, u[0]);
        b[0] = scalar_friction_bend(w0 + u[0]);
        t[0] = scalar_friction_slope(w0 + u[0]);
        tb[0] = t[0] * b[0];
        return;
    }
    out[k] = a * jet_chain(c->work, k, u, t) * jet_inverse[k];
    t[k] = jet_chain(c->work, k, u, tb) * jet_inverse[k];
    b[k] = -jet_square(k, t);
    tb[k] = jet_product(k, t, b);
}

/* jet_product() is core's sum; the formulas' product stores it. */
#define jet_product jet_times
#include "field_formula.h"
#include "rate_formula.h"
#undef jet_product

void field_jet(const struct law *law, const struct anchor *at,
               struct jet_work *w, size_t k, const double x[], const double y[],
               double fx[], double fy[])
{
    struct jet_ctx c = { w, k, w->log_scale, w->frozen };

    w->used = 0;
    jet_field(law, at, &c, x, y, fx, fy);
    w->log_scale = c.scale;
}

void field_jet_rate(const struct law *law, const struct anchor *at,
                    enum block_observable which, struct jet_work *w, size_t k,
                    const double x[], const double y[], double rate[])
{
    struct jet_ctx c = { w, k, w->log_scale, w->frozen };

    jet_rate(law, at, &c, which, w->log_scale, x, y, rate);
}
