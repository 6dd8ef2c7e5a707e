/* Slopes and curvatures are those of the field, dT/dy = 1/y', dX/dy = v/y', and
 * along the curve of dx/dy = x'/y'. */
#include "slow_knot.h"

#include <float.h>
#include <math.h>

#include "slider.h"
#include "slow_tolerance.h"

static double slip_rate(const struct slider *s, double x)
{
    return exp(s->block.at.x0 + x);
}

/* The fast direction and how much faster it is than all else; *slow: the other
 * one. */
static void split(const struct planar_jacobian *J, double speed,
                  struct slow_knot *k, struct vec2 *slow)
{
    const struct eigen2 e = mat2_eigenvalues(J->matrix);
    const double rate = fmax(fabs(e.re[1]), speed);

    k->gap = e.im == 0.0 && e.re[0] < 0.0 ? rate / -e.re[0] : HUGE_VAL;
    k->fast = -e.re[0] * exp(J->field.log_scale);
    k->fold = 1.0 / ((e.re[1] - e.re[0]) * exp(J->field.log_scale));
    k->fibre = mat2_eigenvector(J->matrix, e.re[0]);
    *slow = mat2_eigenvector(J->matrix, e.re[1]);
}

/* Whether a rounding of y, by which the curve is told, shows in x. */
static bool is_too_steep(const struct slow_knot *k)
{
    return slow_knot_is_fast_y(k) && fabs(k->x_slope) * DBL_EPSILON > TOL_TOUCH;
}

bool slow_knot_is_fast_y(const struct slow_knot *k)
{
    return fabs(k->fibre.y) > fabs(k->fibre.x);
}

/* At the offset u with the slope dx/dy, but for the values of time and slip.
 * Where rounding spoils the fast component the curve is as good as along the
 * slow eigenvector. */
void slow_knot_at(const struct slider *s, const double u[], double slope,
                  struct slow_knot *k)
{
    const struct vec2 z = { u[0], u[1] };
    struct planar_jacobian J;
    struct vec2 slow;

    *k = (struct slow_knot){ .y = z.y, .x = z.x, .x_slope = slope };
    s->plane.system.jacobian(s->plane.system.ctx, z, &J);
    struct vec2 d = J.field.direction;
    split(&J, vec2_length(d), k, &slow);
    if (k->gap < TOL_SLOW_ALONG)
        k->x_slope = slope = slow.x / slow.y;
    if (k->gap < TOL_SLOW_NOISY && slow_knot_is_fast_y(k))
        d.y = d.x / slope;
    if (is_too_steep(k))
        k->gap = HUGE_VAL;
    const double rate = d.y * exp(J.field.log_scale);
    const double bend = (J.matrix.yx * slope + J.matrix.yy) / d.y;
    const double v = slip_rate(s, z.x);
    k->x_bend = (J.matrix.xx * slope + J.matrix.xy) / d.y - slope * bend;
    k->time[1] = -1.0 / rate;
    k->time[2] = bend / rate;
    k->slip[1] = -v / rate;
    k->slip[2] = v * (bend - slope) / rate;
}

double slow_knot_change(const struct slow_knot *f, const struct slow_knot *k)
{
    const double time = k->time[2] / k->time[1];
    const double slip = k->slip[2] / k->slip[1];
    const double turn = time - f->time[2] / f->time[1];
    const double most = fmax(fabs(time), fabs(slip));

    return k->y != f->y ? fmax(most, sqrt(fabs(turn / (k->y - f->y)))) : most;
}

/* Sooner where x is the slow one: of y' all is made. */
bool slow_knot_is_noisy(const struct slow_knot *k)
{
    return k->gap < (slow_knot_is_fast_y(k) ? TOL_SLOW_GAP_LEAST_Y
                                            : TOL_SLOW_GAP_LEAST_X);
}

double slow_quintic(const double f[3], const double g[3], double h,
                    double theta, double *slope)
{
    const double f1 = h * f[1], g1 = h * g[1];
    const double f2 = 0.5 * h * h * f[2], g2 = 0.5 * h * h * g[2];
    const double rise = g[0] - f[0];
    const double a = rise - f1 - f2, b = g1 - f1 - 2.0 * f2, c = g2 - f2;
    const double c3 = 10.0 * a - 4.0 * b + c;
    const double c4 = -15.0 * a + 7.0 * b - 2.0 * c;
    const double c5 = 6.0 * a - 3.0 * b + c;
    const double t = theta;

    *slope =
        (f1 + t * (2.0 * f2 + t * (3.0 * c3 + t * (4.0 * c4 + t * 5.0 * c5)))) /
        h;
    return f[0] + t * (f1 + t * (f2 + t * (c3 + t * (c4 + t * c5))));
}

double slow_knot_missed(const struct slow_miss *m, double theta)
{
    const double t = 4.0 * theta * (1.0 - theta);

    return t * (t * t * m->missed + m->rounded);
}

double slow_knot_x(const struct slow_knot *f, const struct slow_knot *g,
                   double theta, double *slope)
{
    const double from[3] = { f->x, f->x_slope, f->x_bend };
    const double to[3] = { g->x, g->x_slope, g->x_bend };

    return slow_quintic(from, to, g->y - f->y, theta, slope);
}

/* (q - q_k - q_k' h)/h^2 for a value with its slope, h beyond that at k, and
 * its derivative. */
static double over_square(const double k[2], const double f[2], double h,
                          double *slope)
{
    const double q = (f[0] - k[0] - k[1] * h) / (h * h);

    *slope = (f[1] - k[1]) / (h * h) - 2.0 * q / h;
    return q;
}

/* q is a cubic by both of them: at y. */
static double rest_at(const double f[2], const double k[2], const double g[2],
                      double before, double after, double y)
{
    const double h = after - before, t = (y - before) / h, u = 1.0 - t;
    double f1, g1;
    const double f0 = over_square(k, f, before, &f1);
    const double g0 = over_square(k, g, after, &g1);

    return u * u * ((1.0 + 2.0 * t) * f0 + t * h * f1) +
           t * t * ((1.0 + 2.0 * u) * g0 - u * h * g1);
}

double slow_knot_bend(const double f[2], const double k[2], const double g[2],
                      double before, double after)
{
    return 2.0 * rest_at(f, k, g, before, after, 0.0);
}

double slow_knot_sixth(const double f[2], const double k[2], const double g[2],
                       double before, double after, double y, double value)
{
    const double p = k[0] + y * (k[1] + y * rest_at(f, k, g, before, after, y));
    const double w = y * (y - before) * (y - after);

    return (value - p) / (w * w);
}

double slow_knot_shift(const struct slow_knot *k, double dx)
{
    return fabs(k->fibre.y * dx / (k->fibre.x - k->fibre.y * k->x_slope));
}

/* Evenly spread over a unit of the last digit. */
static double deviation(double rounded)
{
    const double size = fabs(rounded);

    return (nextafter(size, HUGE_VAL) - size) / sqrt(12.0);
}

double slow_knot_digit(const struct slow_knot *k)
{
    const bool along = isfinite(k->gap);
    const double x = deviation(k->x), y = deviation(k->y);
    const struct vec2 e = along ? k->fibre : (struct vec2){ 1.0, -k->x_slope };

    return hypot(e.x * y, e.y * x) / fabs(e.x - e.y * k->x_slope);
}

double slow_knot_gained(const struct orbit *o, size_t i)
{
    double sum = 0.0;

    if (o->curve.count == 0)
        return 0.0;
    const size_t last = o->curve.count - 1;
    const double *c = curve_component(&o->curve, last, i);
    for (size_t j = o->curve.piece[last].degree; j > 0; j--)
        sum += c[j];
    return sum;
}
