/* The rates of the chart for v -> 0, where psi_ss is 1/v or -ln v, in closed
 * form: of numbers that overflow only logarithms. */
#include "quasistatic.h"

#include <math.h>

#define SCALAR double
#define FN(f)  f
#include "scalar.h"

/* ln(e^u - 1) and ln sinh u; NaN unless u > 0. */
static double ln_expm1(double u)
{
    return u > 1.0   ? u + log1p(-exp(-u))
           : u > 0.0 ? log(expm1(u))
                     : (double) NAN;
}

static double ln_sinh(double u)
{
    return u > 1.0   ? u + log1p(-exp(-2.0 * u)) - log(2.0)
           : u > 0.0 ? log(sinh(u))
                     : (double) NAN;
}

/* theta - theta0, and its slope. */
static double theta_at(const struct block *b, double Y, double *slope)
{
    const struct anchor *at = &b->at;

    *slope = scalar_logistic(at->theta_r, at->theta_s, Y);
    return scalar_log1p_expm1(at->theta_r, at->theta_s, Y);
}

double quasistatic_x(const struct block *b, double Y, double *slope)
{
    const struct anchor *at = &b->at;
    if (b->law.typed)
        return quasistatic_typed_x(b, Y, slope);
    const double theta = theta_at(b, Y, slope);

    *slope *= -at->b / at->a;
    if (at->force0 == 0.0)
        return -at->b / at->a * theta;
    const long double tau = steady_tau(&b->law, &b->material, b->tan_alpha);
    return (double) (tau / (long double) at->a) - at->w0 -
           at->b / at->a * theta;
}

/* mu_log/a = ln(2 sinh(mu/a)) under (4a). */
double quasistatic_above(const struct block *b, double X, double Y,
                         double excess)
{
    if (b->law.typed)
        return quasistatic_typed_above(b, X, Y, excess);
    const double h = excess / b->at.a;
    const double t = (double) b->tan_alpha / b->at.a;
    const double half = sinh(0.5 * h);

    if (b->law.form == FRICTION_LOG || h > 1.0)
        return b->law.form == FRICTION_LOG ? h : ln_sinh(t + h) - ln_sinh(t);
    return log1p(2.0 * half * half + sinh(h) / tanh(t));
}

/* ln(1/T), without what freezes. */
static double log_clock(const struct block *b, double X)
{
    const struct anchor *at = &b->at;
    const struct timescale_terms *t = law_timescale(&b->law);
    const int frozen = law_freezes(&b->law) ? 0 : t->psi_ss;
    const double y0 = law_psi_is_log(&b->law) ? 0.0 : at->y0;
    const double l =
        t->ln_r_plus_v ? scalar_log1p_expm1(at->steady_r, at->steady_s, X) : 0;

    return at->log_rate + y0 + (t->ln_v - t->ln_psi_ss - frozen) * X +
           t->ln_r_plus_v * l;
}

/* ln(psi_ss - psi). */
static double log_gap(const struct block *b, double X, double Y)
{
    const struct anchor *at = &b->at;

    if (!law_psi_is_log(&b->law))
        return at->y0 + Y + ln_expm1(-X - Y);
    if (b->law.psi_ss == PSI_SS_MINUS_LOG)
        return log(-X - Y);
    if (-X > 1.0)
        return at->log_psi0 - X +
               log1p(-(at->psi0 + Y) * exp(X - at->log_psi0));
    return log(at->psi0 * expm1(-X) - Y);
}

/* Kato-Tullis: dY/dt = v (E - z) with z = ln(v psi), E = e^(-v/V_c - z); near
 * the saddle from there, away from it by itself: v0 may be any part of V_c. */
static double log_composite(const struct anchor *at, double X, double Y)
{
    const double q = -X - Y - at->kappa0 * expm1(X);
    const double z = at->x0 + at->y0 + X + Y;

    if (!(q > 1.0))
        return at->x0 + X + log(exp(at->log_composite) * expm1(q) - X - Y);
    const double e = -at->kappa0 * exp(X) - z;
    return at->x0 + X + (e > 0.0 ? e + log1p(-z * exp(-e)) : log(exp(e) - z));
}

/* ln(K(psi_ss - psi) e^(-psi_ss)). */
static double log_frozen(const struct block *b, double X, double Y)
{
    const double y = b->at.y0 + Y, gap = log_gap(b, X, Y);
    const double psi = law_psi_is_log(&b->law) ? y : exp(y);

    return b->law.kinetics == KINETICS_SINH
               ? log1p(-exp(-2.0 * exp(gap))) - log(2.0) - psi
               : gap - b->at.psi0 * exp(-X);
}

double quasistatic_log_rate(const struct block *b, double X, double Y)
{
    const bool is_sinh = b->law.kinetics == KINETICS_SINH;

    if (b->law.typed)
        return quasistatic_typed_log_rate(b, X, Y);
    if (b->law.kinetics == KINETICS_COMPOSITE)
        return log_composite(&b->at, X, Y);
    const double rate = law_freezes(&b->law) ? log_frozen(b, X, Y)
                        : is_sinh            ? ln_sinh(-X - Y)
                                             : log_gap(b, X, Y);
    return log_clock(b, X) + rate -
           (law_psi_is_log(&b->law) ? 0.0 : b->at.y0 + Y);
}
