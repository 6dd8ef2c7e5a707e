/* The field along two curves: a number is their Taylor series, one pair of
 * coefficients a call (core/jet.h).  Helper series take slots of their own. */
#include "field.h"

#include <math.h>

#define KIND(f) jet_##f
#define FN(f)   f
#define REAL(f) pair_##f
#define SCALAR  double
#define VAR(w)  jet_pair *w = c->work->slot[c->used++]
#include "scalar.h"

typedef jet_pair jet_num;
typedef jet_pair jet_real;
struct jet_ctx {
    struct jet_work *work;
    size_t k, used;
    jet_pair scale;
    jet_pair *frozen;
};
#define jet_anchor anchor

/* An expression for each lane i. */
#define EACH(out, value)                                                       \
    do {                                                                       \
        for (int i = 0; i < JET_LANES; i++)                                    \
            (out)[i] = value;                                                  \
    } while (0)

static inline jet_pair pair_size(jet_pair u)
{
    return (jet_pair){ fabs(u[0]), fabs(u[1]) };
}

static inline jet_pair pair_power(jet_pair u)
{
    return (jet_pair){ exp(u[0]), exp(u[1]) };
}

static inline jet_pair pair_ln(jet_pair u)
{
    return (jet_pair){ log(u[0]), log(u[1]) };
}

static inline jet_pair pair_larger(jet_pair u, jet_pair w)
{
    return (jet_pair){ scalar_larger(u[0], w[0]), scalar_larger(u[1], w[1]) };
}

static inline jet_pair pair_at_least(double p, jet_pair u)
{
    return pair_larger(JET_PAIR(p), u);
}

static inline jet_pair pair_choose(jet_pair u, double p, double q, double r)
{
    return (jet_pair){ u[0] < p ? q : r, u[1] < p ? q : r };
}

static inline size_t jet_order(const struct jet_ctx *c)
{
    return c->k;
}

/* r u, and 0 in lanes where r is, whatever u */
static inline jet_pair part(jet_pair r, jet_pair u)
{
    return (jet_pair) ((jet_mask) (r * u) & (r != JET_PAIR(0.0)));
}

static inline void linear(struct jet_ctx *c, jet_pair p, jet_pair q,
                          const jet_pair *u, jet_pair r, const jet_pair *v,
                          jet_pair *out)
{
    const size_t k = c->k;
    const jet_pair sum = q * u[k] + part(r, v[k]);

    out[k] = k == 0 ? p + sum : sum;
}

/* Factors may be plain numbers. */
#define jet_linear(c, p, q, u, r, v, out)                                      \
    linear(c, JET_PAIR(p), JET_PAIR(q), u, JET_PAIR(r), v, out)

static inline void jet_times(struct jet_ctx *c, const jet_pair *u,
                             const jet_pair *v, jet_pair *out)
{
    out[c->k] = jet_product(c->k, u, v);
}

/* j u[j] for j up to k, as a series of its own */
static inline const jet_pair *jet_derivative(struct jet_ctx *c,
                                             const jet_pair *u)
{
    VAR(du);

    du[c->k] = jet_number[c->k] * u[c->k];
    return du;
}

/* w' = s u' w */
static inline void exponential(struct jet_ctx *c, jet_pair l, double s,
                               const jet_pair *u, jet_pair *out)
{
    const jet_pair *du = jet_derivative(c, u);
    const size_t k = c->k;

    out[k] = k == 0 ? pair_power(l) : s * jet_chain(c->work, k, u, du, out);
}
#define jet_exp(c, l, s, u, out) exponential(c, JET_PAIR(l), s, u, out)

/* w' = s u' (w + p), with e = w + p kept as a series of its own */
static inline void exponential_less(struct jet_ctx *c, jet_pair p,
                                    jet_pair log_p, jet_pair s,
                                    const jet_pair *u, jet_pair *out)
{
    VAR(e);
    const jet_pair *du = jet_derivative(c, u);
    const size_t k = c->k;

    if (k > 0) {
        out[k] = e[k] = s * jet_chain(c->work, k, u, du, e);
        return;
    }
    EACH(out[0], scalar_expm1(p[i], log_p[i], s[i] * u[0][i]));
    EACH(e[0], copysign(exp(log_p[i] + s[i] * u[0][i]), p[i]));
}
#define jet_expm1(c, p, log_p, s, u, out)                                      \
    exponential_less(c, JET_PAIR(p), JET_PAIR(log_p), JET_PAIR(s), u, out)

/* p e^u and p e^w as series of their own */
static inline void jet_difference(struct jet_ctx *c, double p,
                                  const jet_pair *u, const jet_pair *w,
                                  jet_pair *out)
{
    VAR(eu);
    VAR(ew);
    const jet_pair *du = jet_derivative(c, u), *dw = jet_derivative(c, w);
    const size_t k = c->k;

    if (k > 0) {
        eu[k] = jet_chain(c->work, k, u, du, eu);
        ew[k] = jet_chain(c->work, k, w, dw, ew);
        out[k] = eu[k] - ew[k];
        return;
    }
    EACH(out[0], scalar_difference(p, u[0][i], w[0][i]));
    EACH(eu[0], scalar_exp(p, u[0][i]));
    EACH(ew[0], scalar_exp(p, w[0][i]));
}

/* w' = p u' with the logistic p, p' = (1 - p) w' */
static inline void jet_log1p_expm1(struct jet_ctx *c, double r, double s,
                                   const jet_pair *u, jet_pair *out)
{
    VAR(p);
    VAR(rest);
    const size_t k = c->k;

    if (s == 0.0) {
        out[k] = u[k];
        return;
    }
    const jet_pair *du = jet_derivative(c, u);
    if (k == 0) {
        EACH(out[0], scalar_log1p_expm1(r, s, u[0][i]));
        EACH(p[0], scalar_logistic(r, s, u[0][i]));
        EACH(rest[0], scalar_logistic_rest(r, s, u[0][i]));
    } else {
        out[k] = jet_chain(c->work, k, u, du, p);
    }
    const jet_pair *dw = jet_derivative(c, out);
    if (k > 0) {
        p[k] = jet_chain(c->work, k, out, dw, rest);
        rest[k] = -p[k];
    }
}

/* s' = c u', c' = s u'; as e^(2u) - 1 over e^u, coefficient k would lose a
 * factor 3^k where u is steep */
static inline void jet_sinh(struct jet_ctx *c, const jet_pair *u, jet_pair *out)
{
    VAR(even);
    const jet_pair *du = jet_derivative(c, u);
    const size_t k = c->k;

    if (k > 0) {
        out[k] = jet_chain(c->work, k, u, du, even);
        even[k] = jet_chain(c->work, k, u, du, out);
        return;
    }
    EACH(out[0], scalar_sinh(u[0][i]));
    EACH(even[0], scalar_cosh(u[0][i]));
}

/* m = asinh(e^w/2): m' = t w', t = tanh m, t' = b m', b = 1 - t^2 */
static inline void jet_friction(struct jet_ctx *c, double a, double w0,
                                double q0, const jet_pair *u, jet_pair *out)
{
    VAR(m);
    VAR(t);
    VAR(b);
    const jet_pair *du = jet_derivative(c, u);
    const size_t k = c->k;

    if (k == 0) {
        EACH(m[0], scalar_friction(w0, q0, u[0][i]));
        EACH(b[0], scalar_friction_bend(w0 + u[0][i]));
        EACH(t[0], scalar_friction_slope(w0 + u[0][i]));
    } else {
        m[k] = jet_chain(c->work, k, u, du, t);
    }
    const jet_pair *dm = jet_derivative(c, m);
    if (k > 0) {
        t[k] = jet_chain(c->work, k, m, dm, b);
        b[k] = -jet_square(k, t);
    }
    out[k] = a * m[k];
}

/* jet_product() is core's sum; the formulas' product stores it. */
#define jet_product jet_times
#include "field_formula.h"
#include "rate_formula.h"
#undef jet_product

static inline void one_order(const struct law *law, const struct anchor *at,
                             struct jet_work *w, size_t k, const jet_pair x[],
                             const jet_pair y[], jet_pair fx[], jet_pair fy[])
{
    struct jet_ctx c = { w, k, 0, w->log_scale, w->frozen };

    jet_field(law, at, &c, x, y, fx, fy);
    w->log_scale = c.scale;
    w->used = c.used;
}

/* Order 0 and the others are compiled apart: each then leaves the other's work
 * out, and all that prepares for it, which is a fifth of the whole. */
__attribute__((flatten)) void field_jet(const struct law *law,
                                        const struct anchor *at,
                                        struct jet_work *w, size_t k,
                                        const jet_pair x[], const jet_pair y[],
                                        jet_pair fx[], jet_pair fy[])
{
    if (k == 0)
        one_order(law, at, w, 0, x, y, fx, fy);
    else
        one_order(law, at, w, k, x, y, fx, fy);
}

void field_jet_rate(const struct law *law, const struct anchor *at,
                    enum block_observable which, struct jet_work *w, size_t k,
                    const jet_pair x[], const jet_pair y[], jet_pair rate[])
{
    struct jet_ctx c = { w, k, w->used, w->log_scale, w->frozen };

    jet_rate(law, at, &c, which, w->log_scale, x, y, rate);
    w->used = c.used;
}
