/*
 * In units of the reach, since c2 and c3 alone may overflow: where a field
 * changes over 1e-200, c3 is 1e400.
 */
#include "eigen_start.h"

#include <math.h>
#include <string.h>

#include "eigen_tolerance.h"

enum { SWEEPS = 8, ATTEMPTS = 300 };

struct vec2 eigen_start_point(const struct eigen_start *t, double p)
{
    return (struct vec2){ p * t->reach, p * p * (t->Y[2] + p * t->Y[3]) };
}

/* reach (S' - Ydot/Xdot) */
static double defect(const struct eigen_frame *g, const struct eigen_start *t,
                     double p)
{
    double none;
    const struct vec2 v = eigen_velocity(g, eigen_start_point(t, p), &none);
    return p * (2.0 * t->Y[2] + 3.0 * p * t->Y[3]) - t->reach * (v.y / v.x);
}

/* A change of coefficient k changes the defect by (k - ratio) p^(k-1), to
 * first order: sweeps of Newton's method with the saddle's own Jacobian. */
static void fit(const struct eigen_frame *g, struct eigen_start *t)
{
    t->Y[2] = t->Y[3] = 0.0;
    for (int i = 0; i < SWEEPS; i++) {
        const double half = 2.0 * defect(g, t, 0.5), far = defect(g, t, 1.0);
        t->Y[2] -= (2.0 * half - far) / (2.0 - g->ratio);
        t->Y[3] -= 2.0 * (far - half) / (3.0 - g->ratio);
    }
}

/* d integral i/d part, over time from the saddle. */
static double integrand(const struct eigen_frame *g,
                        const struct eigen_start *t, size_t i, double p)
{
    double log_scale;
    const struct vec2 W = eigen_start_point(t, p);
    const struct vec2 v = eigen_velocity(g, W, &log_scale);

    return t->reach *
           (eigen_rate(g, i, eigen_point(g->basis, W), log_scale) / v.x);
}

/* What rounding may do to it at the end. */
static double noise(const struct eigen_frame *g, const struct eigen_start *t,
                    size_t i)
{
    double log_scale;
    const struct vec2 W = eigen_start_point(t, 1.0);
    const struct vec2 v = eigen_velocity(g, W, &log_scale);
    const double n =
        eigen_rate_noise(g, i, eigen_point(g->basis, W), log_scale);

    return TOL_ROUNDINGS_MANY * fabs(t->reach * (n / v.x));
}

/* The integrands, smooth but 0/0 at the saddle, are interpolated at thirds of
 * the way.  False if a fourth point does not agree. */
static bool fit_integrals(const struct eigen_frame *g, double tol,
                          struct eigen_start *t)
{
    memset(t->integral, 0, sizeof t->integral);
    for (size_t i = 0; i < g->carry->count; i++) {
        if (!g->converges[i])
            continue;
        const double p = integrand(g, t, i, 1.0 / 3.0);
        const double q = integrand(g, t, i, 2.0 / 3.0);
        const double r = integrand(g, t, i, 1.0);
        const double bend = r - 2.0 * q + p, rise = q - p - 1.5 * bend;
        const double first = p - rise - 0.5 * bend;
        const double test = first + 2.5 * rise + 3.125 * bend;
        const double off = fabs(test - integrand(g, t, i, 5.0 / 6.0));
        if (!(off <= tol * fabs(test) + noise(g, t, i)))
            return false;
        t->integral[i][1] = first;
        t->integral[i][2] = 1.5 * rise;
        t->integral[i][3] = 1.5 * bend;
    }
    return true;
}

enum status eigen_start_find(const struct eigen_frame *g, double tol,
                             double guess, struct eigen_start *t)
{
    memset(t, 0, sizeof *t);
    t->reach = guess;
    for (int i = 0; i < ATTEMPTS; i++) {
        fit(g, t);
        const struct vec2 W = eigen_start_point(t, 1.0);
        const double off = fabs(defect(g, t, 0.75));
        const double allowed = tol * (fabs(W.y) + g->thin * fabs(W.x));
        if (off <= allowed && fit_integrals(g, tol, t))
            return STATUS_OK;
        const double factor = 0.9 * cbrt(allowed / off);
        t->reach *=
            factor > TOL_EIGEN_SHORTEN ? fmin(factor, 0.5) : TOL_EIGEN_SHORTEN;
    }
    return STATUS_NO_CONVERGENCE;
}
