/* Steady states in long double, from the law's formulas.  The extrema of mu_ss
 * are those of mu_log (mu is an increasing function of it); with v as unknown
 * d mu_log/dx = 0 is a quadratic for every composition. */
#include "steady.h"

#include <float.h>
#include <math.h>

#include "law_graph.h"
#include "law_typed.h"

#define FN(f)  f##l
#define SCALAR long double
#include "scalar.h"

/* Formulas that people type may cancel as they like: in 113 bits where long
 * double does not tell the value to 1/32 of a double's last place, an ln psi to
 * that of 1.  *off: what rounding leaves (law_long_rounding), by 113 bits 2^-49
 * times as much. */
static long double typed(struct law_long *p, long double x,
                         enum law_number what, long double *off)
{
    const bool is_log = what == LAW_AT_Y && !law_psi_is_log(p->law);
    const long double value = law_long_steady(p, x, what);
    const long double size = fabsl(value) + (is_log ? 1 : 0);
    struct law_quad fine;

    *off = law_long_rounding(p, what);
    if (32 * *off <= (long double) DBL_EPSILON * size)
        return value;
    *off = LDBL_EPSILON * size + 0x1p-49L * *off;
    law_quad_init(&fine, p->law, p->m, 0);
    return (long double) law_quad_steady(&fine, x, what);
}

static long double steady_at(struct law_long *p, long double x,
                             enum law_number what)
{
    long double off;

    return p->law->typed ? typed(p, x, what, &off)
                         : law_long_steady(p, x, what);
}

static long double steady(const struct law *law, const struct material *m,
                          long double x, enum law_number what)
{
    struct law_long p;

    law_long_init(&p, law, m, 0);
    return steady_at(&p, x, what);
}

long double steady_mu(const struct law *law, const struct material *m,
                      long double x)
{
    return steady(law, m, x, LAW_AT_MU);
}

long double steady_mu_log(const struct law *law, const struct material *m,
                          long double x)
{
    return steady(law, m, x, LAW_AT_MU_LOG);
}

long double steady_mu_log_off(const struct law *law, const struct material *m,
                              long double x)
{
    long double off = 0;
    struct law_long p;

    if (law->typed) {
        law_long_init(&p, law, m, 0);
        (void) typed(&p, x, LAW_AT_MU_LOG, &off);
    }
    return off;
}

long double steady_y(const struct law *law, const struct material *m,
                     long double x)
{
    return steady(law, m, x, LAW_AT_Y);
}

long double steady_psi(const struct law *law, const struct material *m,
                       long double x)
{
    return steady(law, m, x, LAW_AT_PSI);
}

/* 1/R, and c as it stands beside psi: c, or c/(1 + R). */
static long double inverse_R(const struct material *m)
{
    return 1 / (long double) m->R;
}

static long double offset(const struct law *law, const struct material *m)
{
    switch (law->theta) {
        case THETA_LN_C_PSI:
            return (long double) m->c;
        case THETA_LN_C_1PR_PSI:
            return (long double) m->c / (1 + (long double) m->R);
        default:
            return 0;
    }
}

long double steady_log_rate(const struct law *law, const struct material *m,
                            long double x)
{
    const struct timescale_terms *t = law_timescale(law);
    const long double r = inverse_R(m);
    long double sum = t->ln_r ? t->ln_r * logl(r) : 0;

    if (t->ln_v)
        sum += t->ln_v * x;
    if (t->ln_r_plus_v)
        sum += t->ln_r_plus_v * logl(r + expl(x));
    if (t->ln_psi_ss)
        sum += t->ln_psi_ss * logl(steady_psi(law, m, x));
    if (t->psi_ss && !law_freezes(law))
        sum += t->psi_ss * steady_psi(law, m, x);
    return sum;
}

/* tan(alpha) + a ln(1 - exp(-2 tan(alpha)/a)), from (4a) */
long double steady_tau(const struct law *law, const struct material *m,
                       long double tan_alpha)
{
    const long double a = (long double) m->a;
    const bool bent = law->form == FRICTION_ASINH && !law_text(law, LAW_MU);

    return bent ? tan_alpha + a * logl(-expm1l(-2 * tan_alpha / a)) : tan_alpha;
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
    const long double r = inverse_R(m), c = offset(law, m);
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

/* Something else where a number was steady before. */
static long double steady_also(struct law_long *p, long double x,
                               enum law_number what)
{
    long double off;

    return p->law->typed ? typed(p, x, what, &off) : law_long_also(p, what);
}

/* w0 of a law of formulas is that of a friction of this size. */
long double steady_anchor(const struct law *law, const struct material *m,
                          long double tan_alpha, long double x,
                          bool equilibrium, struct anchor *at)
{
    struct law_long p;

    law_long_init(&p, law, m, 0);
    const long double y = steady_at(&p, x, LAW_AT_Y),
                      psi = steady_also(&p, x, LAW_AT_PSI),
                      mu_ss = steady_also(&p, x, LAW_AT_MU),
                      mu_log = steady_also(&p, x, LAW_AT_MU_LOG),
                      mu = equilibrium ? tan_alpha : mu_ss;
    const long double a = (long double) m->a, v = expl(x), c = offset(law, m);
    const long double V = m->V_star, gL = (long double) m->g * m->L;

    *at = (struct anchor){
        .x0 = (double) x,
        .y0 = (double) y,
        .v0 = (double) v,
        .psi0 = (double) psi,
        .mu0 = (double) mu,
        .force0 = (double) (tan_alpha - mu),
        .a = m->a,
        .b = m->b,
        .theta_r = (double) (c > 0 ? psi / (c + psi) : 1),
        .theta_s = (double) (c > 0 ? c / (c + psi) : 0),
        .log_inertia = (double) (-logl(V * V / gL) -
                                 log1pl(tan_alpha * tan_alpha) / 2 - x),
        .log_rate = (double) (steady_log_rate(law, m, x) -
                              (law_psi_is_log(law) ? 0 : y)),
        .w0 = (double) (law_text(law, LAW_MU) ? logl(mu_ss / a) : mu_log / a),
    };
    return y;
}

/* A root in 113 bits, for the tape's constants are made of it. */
static formula_real place(const struct law *law, const struct material *m,
                          long double x)
{
    struct law_quad p;

    if (law_text(law, LAW_PSI_SS))
        return steady_y(law, m, x);
    law_quad_init(&p, law, m, 0);
    return law_quad_steady(&p, x, LAW_AT_Y);
}

bool steady_plane(const struct law *law, const struct material *m,
                  long double tan_alpha, long double x, bool equilibrium,
                  struct tape_plane *plane)
{
    struct formula_value leaf[LAW_VALUES];
    struct tape_lowered room;
    struct fault why;
    const formula_real y = place(law, m, x);

    law_values(law, m, tan_alpha, x, y, leaf);
    return tape_plane_at(law_tape_kept(law, equilibrium, &room), leaf,
                         (formula_real[]){ x, y }, plane, &why) == STATUS_OK;
}
