/* The formulas of lib/friction in 113 bits: a number is its value. */
#include "quad_block.h"

#define T       quad
#define NAME(f) quad_##f
#define KIND(f) quad_##f
#define FN(f)   f##q
#define REAL(f) scalar_##f
#define SCALAR  quad
#define VAR(w)  quad w[1]
#include "scalar.h"
#include "steady_formula.h"

typedef quad quad_num;
typedef quad quad_real;
struct quad_ctx {
    quad scale, frozen[4];
};

static inline int quad_order(const struct quad_ctx *c)
{
    (void) c;
    return 0;
}

static inline void quad_linear(struct quad_ctx *c, quad p, quad q,
                               const quad *u, quad r, const quad *v, quad *out)
{
    (void) c;
    out[0] = p + q * u[0] + (r == 0 ? 0 : r * v[0]);
}

static inline void quad_product(struct quad_ctx *c, const quad *u,
                                const quad *v, quad *out)
{
    (void) c;
    out[0] = u[0] * v[0];
}

static inline void quad_exp(struct quad_ctx *c, quad l, quad s, const quad *u,
                            quad *out)
{
    (void) c, (void) s, (void) u;
    out[0] = expq(l);
}

static inline void quad_expm1(struct quad_ctx *c, quad p, quad log_p, quad s,
                              const quad *u, quad *out)
{
    (void) c;
    out[0] = scalar_expm1(p, log_p, s * u[0]);
}

static inline void quad_difference(struct quad_ctx *c, quad p, const quad *u,
                                   const quad *w, quad *out)
{
    (void) c;
    out[0] = scalar_difference(p, u[0], w[0]);
}

static inline void quad_log1p_expm1(struct quad_ctx *c, quad r, quad s,
                                    const quad *u, quad *out)
{
    (void) c;
    out[0] = scalar_log1p_expm1(r, s, u[0]);
}

static inline void quad_sinh(struct quad_ctx *c, const quad *u, quad *out)
{
    (void) c;
    out[0] = scalar_sinh(u[0]);
}

static inline void quad_friction(struct quad_ctx *c, quad a, quad w0, quad q0,
                                 const quad *u, quad *out)
{
    (void) c;
    out[0] = a * scalar_friction(w0, q0, u[0]);
}

#include "field_formula.h"
#include "rate_formula.h"

quad quad_block_mu_ss(const struct law *law, const struct material *m, quad x)
{
    return quad_mu_ss(law, m, x);
}

quad quad_block_y_ss(const struct law *law, const struct material *m, quad x)
{
    return quad_y_ss(law, m, x);
}

quad quad_block_equilibrium(const struct law *law, const struct material *m,
                            quad tan_alpha, quad lo, quad hi)
{
    const quad tau = quad_tau(law, m, tan_alpha);
    const bool rises = quad_mu_log_ss(law, m, lo) < tau;

    for (quad mid = (lo + hi) / 2; lo < mid && mid < hi; mid = (lo + hi) / 2)
        if ((quad_mu_log_ss(law, m, mid) < tau) == rises)
            lo = mid;
        else
            hi = mid;
    return lo;
}

void quad_block_anchor(const struct law *law, const struct material *m,
                       quad tan_alpha, quad x, bool equilibrium,
                       struct quad_anchor *at)
{
    quad_anchor(law, m, tan_alpha, x, equilibrium, at);
}

void quad_block_field(const struct law *law, const struct quad_anchor *at,
                      quad X, quad Y, struct quad_field *f)
{
    struct quad_ctx c = { 0 };

    quad_field(law, at, &c, &X, &Y, &f->direction[0], &f->direction[1]);
    f->log_scale = c.scale;
}

quad quad_block_rate(const struct law *law, const struct quad_anchor *at,
                     enum block_observable which, quad X, quad Y)
{
    struct quad_ctx c = { 0 };
    quad rate;

    quad_rate(law, at, &c, which, 0, &X, &Y, &rate);
    return rate;
}

quad quad_block_mu(const struct law *law, const struct quad_anchor *at, quad X,
                   quad Y)
{
    struct quad_ctx c = { 0 };
    quad mu;

    quad_mu(law, at, &c, &X, &Y, &mu);
    return at->mu0 + mu;
}
