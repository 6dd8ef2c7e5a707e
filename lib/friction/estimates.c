/* Formulas (29)-(42).  Roots are sought on logarithms of ratios, which neither
 * overflow nor cancel, down to neighbouring numbers: their shape says how many
 * there are and between which two points. */
#include "estimates.h"

#include <float.h>
#include <math.h>

#include "newton.h"
#include "tolerance.h"

/* What a root function needs. */
struct root_context {
    double psi;            /* psi_sp0 */
    double constant, size; /* chi: and how large its terms are */
    double slope;          /* xi: y = slope * x on Y = 0 */
};

typedef double root_function(const void *ctx, double x);

/* NaN where f does not change its sign. */
static double root_between(root_function *f, const struct root_context *c,
                           double lo, double hi)
{
    struct newton_root root;

    return newton_find(f, c, lo, hi, 0.0, &root) == STATUS_OK ? root.x
                                                              : (double) NAN;
}

/* ln sinh u, u > 0 */
static double log_sinh(double u)
{
    return u > 1.0 ? u + log(-0.5 * expm1(-2.0 * u)) : log(sinh(u));
}

double estimates_persistence(double eta, double psi_sp)
{
    return eta * log1p(2.0 / expm1(psi_sp));
}

bool estimates_at(const struct law *law, const struct material *m,
                  double tan_alpha, struct estimates *e)
{
    const double d = m->b - m->a, tiny = 1e-16;

    if (!law_is_hyperbolic(law, m) || !(d > 0.0))
        return false;
    const double eta = law_eta(law, m), x = (m->mu_star - tan_alpha) / d;
    const double f = m->mu_star + d * log(log(2.0 * eta / tiny));
    *e = (struct estimates){
        .eta = eta,
        .ln_v_sp0 = x,
        .v_sp0 = exp(x),
        .psi_sp0 = exp(-x),
        .x_k = estimates_persistence(eta, exp(-x)),
        .x_k_small_psi = eta * (M_LN2 + x),
        .x_k_zero_slope = eta * (M_LN2 + m->mu_star / d),
        .alpha_f = atan(f),
        .tan_alpha_f = f,
    };
    return true;
}

/* ---- chi(v) = 1 -------------------------------------------------------- */

/* ln chi with x = ln(v/v_sp0): 2x + const + ln(sinh(psi (1 - e^-x))/x) */
static double log_chi(const void *ctx, double x)
{
    const struct root_context *c = ctx;
    const double u = -c->psi * expm1(-x);

    if (x == 0.0)
        return c->constant + log(c->psi);
    return 2.0 * x + c->constant + log_sinh(fabs(u)) - log(fabs(x));
}

/* Its derivative, which grows from -infinity to 2.  Beside 0, where its terms
 * cancel, by its series: where psi x is not small either, only its sign is
 * right, and it has no other root there. */
static double log_chi_slope(const void *ctx, double x)
{
    const struct root_context *c = ctx;
    const double u = -c->psi * expm1(-x), du = c->psi * exp(-x);

    if (fabs(x) < 1e-5)
        return 1.5 + x / 12.0 + c->psi * (c->psi * x) / 3.0;
    return 2.0 + du / tanh(u) - 1.0 / x;
}

/* What ln chi may be off by at x: the roundings of its terms, and `unsure` of
 * ln v_sp0, by which its derivative is 3 - u/tanh(u). */
static double log_chi_noise(const struct root_context *c, double unsure,
                            double x)
{
    const double u = fabs(c->psi * expm1(-x)),
                 grows = u > 1.0 ? u / tanh(u) : 1.5;
    const double sizes =
        2.0 * fabs(x) + c->size + fabs(log_sinh(u)) + fabs(log(fabs(x)));

    return (3.0 + grows) * unsure +
           DBL_EPSILON * (8.0 + 2.0 * sizes + 4.0 * grows);
}

/* How far from the root x towards `end`, of which f has the sign, it takes for
 * the sign to be beyond doubt; infinite where it is not even at the end. */
static double log_chi_reach(const struct root_context *c, double unsure,
                            double x, double end)
{
    const double whole = fabs(end - x), side = end > x ? 1.0 : -1.0;
    const double slope = fabs(log_chi_slope(c, x));

    for (double h = log_chi_noise(c, unsure, x) / slope; h < whole; h *= 2.0) {
        const double at = x + side * h;
        if (at != 0.0 && fabs(log_chi(c, at)) > log_chi_noise(c, unsure, at))
            return h;
    }
    return (double) HUGE_VAL;
}

/* Where the bottom between both roots may be at 1, they may be anywhere between
 * their outer reaches. */
static void bound_roots(const struct root_context *c, double unsure, double lo,
                        double bottom, double hi, struct estimates_root root[2])
{
    const double out[2] = { log_chi_reach(c, unsure, root[0].x, lo),
                            log_chi_reach(c, unsure, root[1].x, hi) };
    const double width = root[1].x - root[0].x;

    for (int i = 0; i < 2; i++) {
        const double in = log_chi_reach(c, unsure, root[i].x, bottom);
        root[i].error =
            isfinite(in) ? fmax(in, out[i]) : width + out[0] + out[1];
    }
}

size_t estimates_chi(const struct material *m, const struct estimates *e,
                     double tan_alpha, double unsure,
                     struct estimates_root root[2])
{
    const double a_cos = m->a / hypot(1.0, tan_alpha);
    const double front = log(material_eps2(m) / (e->eta * a_cos));
    const struct root_context c = {
        .psi = e->psi_sp0,
        .constant = front + 3.0 * e->ln_v_sp0,
        .size = fabs(front) + 3.0 * fabs(e->ln_v_sp0),
    };
    double lo = -1.0, hi = 1.0;

    while (log_chi_slope(&c, lo) > 0.0 && lo > -1e6)
        lo *= 2.0;
    while (log_chi_slope(&c, hi) < 0.0 && hi < 1e6)
        hi *= 2.0;
    const double bottom = root_between(log_chi_slope, &c, lo, hi);
    if (!(log_chi(&c, bottom) < 0.0))
        return 0;
    for (double step = 1.0; log_chi(&c, lo) < 0.0 && step < 1e6; step *= 2.0)
        lo -= step;
    for (double step = 1.0; log_chi(&c, hi) < 0.0 && step < 1e6; step *= 2.0)
        hi += step;
    root[0].x = root_between(log_chi, &c, lo, bottom);
    root[1].x = root_between(log_chi, &c, bottom, hi);
    bound_roots(&c, unsure, lo, bottom, hi, root);
    return 2;
}

/* ---- dY/dX = -xi ------------------------------------------------------- */

/* ln of the ratio of the two terms of (38) on Y = 0, x = B X, y = slope x:
 * positive between the saddle and the root.
 *
 * With s = slope > 0, k = (1 + s)/2, L(z) = ln(sinh(z)/z), and a constant C,
 *
 *     x > 0:  ratio = C - L(k x) - L(u) - (3 - s)/2 x,
 *             u = psi (e^(s x) - e^-x) = 2 psi e^((s-1)x/2) sinh(k x),
 *
 * and x < 0 is the same in t = -x with s - 3 for 3 - s and
 * u = psi (e^t - e^(-s t)).  L' > 0, L'' > 0 and u' > 0 for positive arguments,
 * so that each ratio either falls, or is concave, or has at least no second
 * maximum; it ends at -infinity.  Hence one that is positive near the saddle
 * has exactly one root, and one that is not has none:
 *   x > 0: where s <= 3, it falls; where s >= 1, u'' >= 0 and it is concave.
 *   x < 0: where s >= 3, it falls; where s <= 1, u'' >= 0 and it is concave.
 *     Where 1 < s < 3, it is concave beyond k t = ln s, where u'' >= 0. Before,
 *     -u''/u' <= s - 1, and where the ratio is level, L'(u) u' <= (3 - s)/2, so
 *     -ratio'' >= k^2 L''(ln s) - (s - 1)(3 - s)/2, which is > 0.02: every
 * level point is a maximum. */
static double log_xi_ratio(const void *ctx, double x)
{
    const struct root_context *c = ctx;
    const double y = c->slope * x;
    const double top = fmax(y, -x), gap = -expm1(-fabs(x + y));
    const double u = top > 700.0 ? HUGE_VAL : c->psi * exp(top) * gap;

    return c->constant + log(fabs(x)) - 2.0 * x + y - log_sinh(u);
}

static double xi_root(const struct root_context *c, int side)
{
    /* nearer, the manifold is a vertical wall, and the equation says nothing;
       beyond 1 over it v is no number */
    double near = TOL_SAME, far = 1.0;

    if (!(log_xi_ratio(c, side * near) > 0.0))
        return (double) NAN;
    for (; log_xi_ratio(c, side * far) > 0.0 && far < 1.0 / TOL_SAME; far *= 2)
        near = far;
    return root_between(log_xi_ratio, c, fmin(side * near, side * far),
                        fmax(side * near, side * far));
}

struct estimates_xi estimates_xi_at(const struct material *m,
                                    const struct estimates *e, double tan_alpha,
                                    double xi)
{
    const double per_v = 1.0 / (hypot(1.0, tan_alpha) * material_eps2(m));
    const double A = m->a * per_v * e->psi_sp0, B = m->b * per_v * e->psi_sp0;
    const double rate = e->v_sp0; /* 1/psi_sp0 */
    /* lambda^2 + (A + rate) lambda + rate (A - B) = 0, rate B = per_v b */
    const double half = 0.5 * (A + rate), product = per_v * (m->b - m->a);
    const double minus = -half - hypot(half, sqrt(product));
    const double plus = -product / minus;
    const double upper = A + plus, lower = -B * rate / upper; /* A + lambda */
    const struct root_context c = {
        .psi = e->psi_sp0,
        .slope = -lower / B,
        .constant = log(-minus) + log(xi * upper - lower) - log1p(-xi) -
                    log(B) - 2.0 * e->ln_v_sp0,
    };

    return (struct estimates_xi){ xi_root(&c, -1), xi_root(&c, 1) };
}

struct estimates_strength estimates_strength_at(const struct material *m,
                                                double tan_alpha, double v_sp,
                                                double x_k, double ln_ratio)
{
    const double G = 0.5 * material_eps2(m) * hypot(1.0, tan_alpha) * v_sp *
                     v_sp * expm1(2.0 * ln_ratio);
    return (struct estimates_strength){ tan_alpha + G / x_k, G };
}
