/* Steady states in long double, from the formulas of steady_formula.h.  The
 * extrema of mu_ss are those of mu_log (mu is an increasing function of it);
 * with v as unknown d mu_log/dx = 0 is a quadratic for every composition. */
#include "steady.h"

#include <math.h>

#include "law_root.h"
#include "law_typed.h"

#define T       long double
#define NAME(f) ld_##f
#define FN(f)   f##l
#define REAL(f) scalar_##f
#define SCALAR  long double
#include "scalar.h"
struct ld_anchor {
    ANCHOR_MEMBERS(long double)
};
#include "steady_formula.h"

long double steady_mu(const struct law *law, const struct material *m,
                      long double x)
{
    return law->typed ? law_typed_steady(law, m, x).mu : ld_mu_ss(law, m, x);
}

long double steady_mu_log(const struct law *law, const struct material *m,
                          long double x)
{
    return law->typed ? law_typed_steady(law, m, x).mu
                      : ld_mu_log_ss(law, m, x);
}

long double steady_y(const struct law *law, const struct material *m,
                     long double x)
{
    return law->typed ? law_typed_steady(law, m, x).y : ld_y_ss(law, m, x);
}

long double steady_psi(const struct law *law, const struct material *m,
                       long double x)
{
    return law->typed ? law_typed_steady(law, m, x).psi : ld_psi_ss(law, m, x);
}

long double steady_log_rate(const struct law *law, const struct material *m,
                            long double x)
{
    return ld_log_rate(law, m, x);
}

long double steady_tau(const struct law *law, const struct material *m,
                       long double tan_alpha)
{
    return law->typed ? tan_alpha : ld_tau(law, m, tan_alpha);
}

long double steady_x_max(const struct law *law)
{
    return law->psi_ss == PSI_SS_MINUS_LOG && !law_psi_is_log(law)
               ? 0.0L
               : (long double) HUGE_VAL;
}

/* Positive roots v of p v^2 + q v + r = 0 as ln v, ascending.  The larger
 * root in magnitude first, the other by Vieta. */
static size_t log_roots(long double p, long double q, long double r,
                        long double x[4])
{
    const long double disc = q * q - 4 * p * r;
    size_t n = 0;

    if (!(disc >= 0))
        return 0;
    const long double far = -(q + copysignl(sqrtl(disc), q)) / 2;
    const long double root[2] = { far / p, far == 0 ? 0 : r / far };
    for (int i = 0; i < 2; i++)
        if (root[i] > 0 && isfinite(root[i]))
            x[n++] = logl(root[i]);
    if (n == 2 && x[0] > x[1]) {
        const long double swap = x[0];
        x[0] = x[1];
        x[1] = swap;
    }
    return n;
}

/* a = b k u/(1 + u) + b with u = W(exp(-k)), k = v/V_c: none or two roots,
 * one on each side of the maximum of k u/(1 + u). */
static long double composite_slope(const struct material *m, long double x)
{
    const long double k = expl(x) / (long double) m->V_c, u = scalar_lambert(k);
    const long double rise = k * u / (1 + u);
    return (long double) m->a - (long double) m->b * (1 + rise);
}

static long double bisect_slope(const struct material *m, long double lo,
                                long double hi)
{
    const bool up = composite_slope(m, lo) < 0;

    for (int i = 0; i < 120; i++) {
        const long double mid = (lo + hi) / 2;
        if ((composite_slope(m, mid) < 0) == up)
            lo = mid;
        else
            hi = mid;
    }
    return (lo + hi) / 2;
}

static size_t composite_extrema(const struct material *m, long double x[4])
{
    long double lo = logl((long double) m->V_c) - 8;
    long double hi = logl((long double) m->V_c) + 5;

    for (int i = 0; i < 120; i++) { /* the minimum of the slope, by thirds */
        const long double s = lo + (hi - lo) / 3, t = hi - (hi - lo) / 3;
        if (composite_slope(m, s) < composite_slope(m, t))
            hi = t;
        else
            lo = s;
    }
    if (!(m->a > m->b) || composite_slope(m, lo) > 0)
        return 0;
    x[0] = bisect_slope(m, lo - 100, lo);
    x[1] = bisect_slope(m, lo, lo + 20);
    return 2;
}

/* theta = psi: a + b psi_ss'(x) = 0. */
static size_t extrema_of_plain_psi(const struct law *law, long double a,
                                   long double b, long double r,
                                   long double x[4])
{
    switch (law->psi_ss) {
        case PSI_SS_INVERSE:
            x[0] = logl(b / a);
            return 1;
        case PSI_SS_SPINODAL: /* a (r + v)^2 = b (1 + r) v */
            return log_roots(a, 2 * a * r - b * (1 + r), a * r * r, x);
        case PSI_SS_SPINODAL_UNIT:
            return log_roots(a, 2 * a * r - b * r, a * r * r, x);
        default:
            return 0;
    }
}

size_t steady_extrema(const struct law *law, const struct material *m,
                      long double x[4])
{
    if (law->typed)
        return law_typed_extrema(law, m, x);
    const long double a = (long double) m->a, b = (long double) m->b;
    const long double r = ld_inverse_R(m), c = ld_offset(law, m);
    const long double top = law->psi_ss == PSI_SS_SPINODAL ? 1 + r : r;

    if (law->psi_ss == PSI_SS_LAMBERT)
        return composite_extrema(m, x);
    if (law_psi_is_log(law))
        return extrema_of_plain_psi(law, a, b, r, x);
    switch (law->psi_ss) {
        case PSI_SS_INVERSE: /* a (1 + c v) = b */
            if (!(c > 0 && b > a))
                return 0;
            x[0] = logl((b / a - 1) / c);
            return 1;
        case PSI_SS_MINUS_LOG: /* a (c - x) = b, x < 0 */
            x[0] = c - b / a;
            return x[0] < 0 ? 1 : 0;
        default: /* a (r + v)(top + c r + c v) = b top v */
            if (!(c > 0)) {
                x[0] = logl(a * r / (b - a));
                return b > a && r > 0 ? 1 : 0;
            }
            return log_roots(a * c, a * (top + 2 * c * r) - b * top,
                             a * r * (top + c * r), x);
    }
}

/* As far as a law of formulas has them: w0 is that of a friction of this
 * size, and the rest is in its tape. */
static void typed_anchor(const struct law *law, const struct material *m,
                         long double tan_alpha, long double x, bool equilibrium,
                         struct anchor *at)
{
    const struct typed_steady s = law_typed_steady(law, m, x);
    const long double eps2 = ld_eps2(m);

    *at = (struct anchor){
        .x0 = (double) x,
        .y0 = (double) s.y,
        .v0 = (double) expl(x),
        .psi0 = (double) s.psi,
        .log_psi0 = (double) logl(fabsl(s.psi)),
        .mu0 = (double) (equilibrium ? tan_alpha : s.mu),
        .force0 = equilibrium ? 0.0 : (double) (tan_alpha - s.mu),
        .a = m->a,
        .b = m->b,
        .log_inertia =
            (double) (-logl(eps2) - log1pl(tan_alpha * tan_alpha) / 2 - x),
        .kept = 1.0,
        .w0 = (double) logl(s.mu / (long double) m->a),
    };
}

/* What is left of p when a double holds it. */
static long double remainder_of(long double p)
{
    return p - (long double) (double) p;
}

void steady_anchor(const struct law *law, const struct material *m,
                   long double tan_alpha, long double x, bool equilibrium,
                   struct anchor *at)
{
    struct ld_anchor p;

    if (law->typed) {
        typed_anchor(law, m, tan_alpha, x, equilibrium, at);
        return;
    }
    ld_anchor(law, m, tan_alpha, x, equilibrium, &p);
    *at = (struct anchor){
        .x0 = (double) p.x0,
        .y0 = (double) p.y0,
        .v0 = (double) p.v0,
        .psi0 = (double) p.psi0,
        .log_psi0 = (double) p.log_psi0,
        .mu0 = (double) p.mu0,
        .force0 = (double) p.force0,
        .a = (double) p.a,
        .b = (double) p.b,
        .theta_r = (double) p.theta_r,
        .theta_s = (double) p.theta_s,
        .steady_r = (double) p.steady_r,
        .steady_s = (double) p.steady_s,
        .log_inertia = (double) p.log_inertia,
        .log_rate = (double) p.log_rate,
        .kept = (double) expl(remainder_of(p.log_inertia) -
                              remainder_of(p.log_rate)),
        .w0 = (double) p.w0,
        .q0 = (double) p.q0,
        .kappa0 = (double) p.kappa0,
        .log_kappa0 = (double) p.log_kappa0,
        .log_composite = (double) p.log_composite,
    };
}

bool steady_plane(const struct law *law, const struct material *m,
                  long double tan_alpha, long double x, bool equilibrium,
                  struct tape_plane *plane)
{
    const formula_real root = law_root_quad(law, m, x);
    const formula_real anchor[2] = { x, law_text(law, LAW_PSI_SS)
                                            ? steady_y(law, m, x)
                                            : root };
    struct formula_value leaf[LAW_VALUES];
    struct tape_lowered room;
    struct fault why;

    law_values(law, m, tan_alpha, x, root, leaf);
    return tape_plane_at(law_tape_kept(law, equilibrium, &room), leaf, anchor,
                         plane, &why) == STATUS_OK;
}
