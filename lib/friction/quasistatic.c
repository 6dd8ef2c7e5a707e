/* The rates of the chart for v -> 0, where psi_ss is 1/v or -ln v, in closed
 * form: of numbers that overflow only logarithms. */
#include "quasistatic.h"

#include <math.h>

#define SCALAR double
#define FN(f)  f
#include "scalar.h"

/* ln sinh u; NaN unless u > 0. */
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
    return (double) (b->tau / (long double) at->a) - at->w0 -
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
