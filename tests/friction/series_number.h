/* Whole series of 113-bit coefficients as the numbers of field_formula.h, with
 * recurrences of their own. */
#pragma once

#include "quad.h"

enum { ORDER = 24, N = ORDER + 1 };

#define KIND(f) series_##f
#define FN(f)   f##q
#define REAL(f) scalar_##f
#define SCALAR  quad
#define VAR(w)  quad w[N]
#include "scalar.h"

typedef quad series_num;
typedef quad series_real;
struct series_ctx {
    quad scale, frozen[4];
};
#define series_anchor exact_anchor

static int series_order(const struct series_ctx *c)
{
    (void) c;
    return 0;
}

static void series_linear(struct series_ctx *c, quad p, quad q, const quad *u,
                          quad r, const quad *v, quad *out)
{
    (void) c;
    for (int k = 0; k < N; k++)
        out[k] = q * u[k] + r * v[k];
    out[0] += p;
}

static void series_product(struct series_ctx *c, const quad *u, const quad *v,
                           quad *out)
{
    quad sum[N] = { 0 };

    (void) c;
    for (int i = 0; i < N; i++)
        for (int j = 0; u[i] != 0 && i + j < N; j++)
            sum[i + j] += u[i] * v[j];
    for (int k = 0; k < N; k++)
        out[k] = sum[k];
}

/* u/v */
static void over(const quad *u, const quad *v, quad *out)
{
    for (int k = 0; k < N; k++) {
        quad sum = u[k];
        for (int j = 1; j <= k; j++)
            sum -= v[j] * out[k - j];
        out[k] = sum / v[0];
    }
}

/* The integral of v u' from `start` */
static void integral(const quad *v, const quad *u, quad start, quad *out)
{
    out[0] = start;
    for (int k = 1; k < N; k++) {
        out[k] = 0;
        for (int j = 1; j <= k; j++)
            out[k] += j * u[j] * v[k - j] / k;
    }
}

static void series_exp(struct series_ctx *c, quad l, quad s, const quad *u,
                       quad *out)
{
    quad power[N], term[N] = { 1 };

    out[0] = 1;
    for (int k = 1; k < N; k++)
        out[k] = 0;
    for (int k = 0; k < N; k++)
        power[k] = k == 0 ? 0 : s * u[k];
    for (int j = 1; j < N; j++) { /* e^w = sum of w^j/j!, w[0] = 0 */
        series_product(c, term, power, term);
        for (int k = 0; k < N; k++) {
            term[k] /= j;
            out[k] += term[k];
        }
    }
    for (int k = 0; k < N; k++)
        out[k] *= expq(l);
}

static void series_expm1(struct series_ctx *c, quad p, quad log_p, quad s,
                         const quad *u, quad *out)
{
    series_exp(c, log_p + s * u[0], s, u, out);
    for (int k = 0; k < N; k++)
        out[k] = copysignq(1, p) * out[k];
    out[0] = scalar_expm1(p, log_p, s * u[0]);
}

static void series_difference(struct series_ctx *c, quad p, const quad *u,
                              const quad *w, quad *out)
{
    quad e[N];

    series_exp(c, u[0], 1, u, out);
    series_exp(c, w[0], 1, w, e);
    for (int k = 0; k < N; k++)
        out[k] = p * (out[k] - e[k]);
}

static void series_log1p_expm1(struct series_ctx *c, quad r, quad s,
                               const quad *u, quad *out)
{
    quad g[N], part[N];

    series_exp(c, u[0], 1, u, g);
    for (int k = 0; k < N; k++)
        g[k] *= r;
    for (int k = 0; k < N; k++)
        part[k] = g[k];
    part[0] += s;
    over(g, part, g);
    integral(g, u, scalar_log1p_expm1(r, s, u[0]), out);
}

static void series_sinh(struct series_ctx *c, const quad *u, quad *out)
{
    quad e[N];

    series_exp(c, u[0] - fabsq(u[0]), 1, u, out);
    series_exp(c, -u[0] - fabsq(u[0]), -1, u, e);
    for (int k = 0; k < N; k++)
        out[k] = (out[k] - e[k]) / 2;
}

/* The slope of asinh(e^w/2) is 1/sqrt(1 + 4 e^(-2 w)). */
static void series_friction(struct series_ctx *c, quad a, quad w0, quad q0,
                            const quad *u, quad *out)
{
    quad g[N], root[N], one[N] = { 1 };

    series_exp(c, -2 * (w0 + u[0]), -2, u, g);
    for (int k = 0; k < N; k++)
        g[k] *= 4;
    g[0] += 1;
    root[0] = sqrtq(g[0]);
    for (int k = 1; k < N; k++) {
        quad sum = g[k];
        for (int j = 1; j < k; j++)
            sum -= root[j] * root[k - j];
        root[k] = sum / (2 * root[0]);
    }
    over(one, root, g);
    integral(g, u, scalar_friction(w0, q0, u[0]), out);
    for (int k = 0; k < N; k++)
        out[k] *= a;
}

/* What field_formula.h asks of the elements of its numbers. */
static quad scalar_size(quad u)
{
    return fabsq(u);
}

static quad scalar_power(quad u)
{
    return expq(u);
}

static quad scalar_ln(quad u)
{
    return logq(u);
}

static quad scalar_at_least(quad p, quad u)
{
    return u > p ? u : p;
}

static quad scalar_choose(quad u, quad p, quad q, quad r)
{
    return u < p ? q : r;
}
