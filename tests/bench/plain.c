#include "plain.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>
#include <math.h>
#include <string.h>
#include <time.h>

double plain_now(void)
{
    struct timespec t;

    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double) t.tv_sec + 1e-9 * (double) t.tv_nsec;
}

double plain_worked(void)
{
    return (double) clock() / CLOCKS_PER_SEC;
}

struct plain plain_of(const struct block *b, const struct equilibrium *e)
{
    const bool log_form = b->law.form == FRICTION_LOG;

    return (struct plain){
        .spinodal = strcmp(b->law.preset, "spinodal_gen") == 0,
        .a = b->at.a,
        .b = b->at.b,
        .c = b->material.c,
        .R = b->material.R,
        .A = exp(b->at.log_inertia),
        .v = b->at.v0,
        .psi = b->at.psi0,
        .s0 = log_form ? 0.0 : sqrt(1.0 + 4.0 * exp(-2.0 * b->at.w0)),
        .lambda = e->lambda[0],
        .stable = mat2_eigenvector(e->matrix, e->scaled[0]),
    };
}

static double mu(const struct plain *p, double X, double Y)
{
    const double theta =
        p->spinodal ? log1p(p->psi / (p->c + p->psi) * expm1(Y)) : Y;
    const double mu = p->a * X + p->b * theta;

    if (p->s0 == 0.0)
        return mu;
    const double q = p->s0 * p->s0 - 1.0;
    const double s = sqrt(1.0 + q * exp(-2.0 * mu / p->a));
    return mu + p->a * log1p(q * expm1(-2.0 * mu / p->a) / (s + p->s0) /
                             (1.0 + p->s0));
}

double plain_field(const struct plain *p, double X, double Y, double f[2])
{
    const double v = p->v * exp(X);
    const double D =
        p->spinodal
            ? p->psi * (expm1(Y) + p->R * p->v * expm1(X) / (1.0 + p->R * v))
            : p->psi * (expm1(Y) - expm1(-X));
    const double T = p->spinodal ? p->R / (1.0 + p->R * v) : 1.0 / v;
    const double K = -0.5 * copysign(1.0, D) * expm1(-2.0 * fabs(D));

    f[0] = -p->A * mu(p, X, Y) * exp(-X - fabs(D));
    f[1] = -K / (T * p->psi) * exp(-Y);
    return fabs(D);
}

static int rhs(double t, const double z[], double d[], void *ctx)
{
    struct plain *p = ctx;
    double f[2];
    const double large = plain_field(p, z[0], z[1], f);
    const double n = -hypot(f[0], f[1]); /* backward in time */

    (void) t;
    p->calls++;
    d[0] = f[0] / n;
    d[1] = f[1] / n;
    d[2] = p->v * expm1(z[0]) * exp(-large) / n;
    return GSL_SUCCESS;
}

static void branch(struct plain *p, double side, double tol, double z[3])
{
    gsl_odeiv2_system sys = { rhs, NULL, 3, p };
    gsl_odeiv2_step *step = gsl_odeiv2_step_alloc(gsl_odeiv2_step_rk8pd, 3);
    gsl_odeiv2_control *control = gsl_odeiv2_control_y_new(tol, tol);
    gsl_odeiv2_evolve *evolve = gsl_odeiv2_evolve_alloc(3);
    const double start = tol < 1e-9 ? 1e-6 : 1e-4;
    double t = 0.0, h = 1e-3;

    z[0] = side * start * p->stable.x;
    z[1] = side * start * p->stable.y;
    z[2] = p->v * z[0] / p->lambda; /* from the saddle to here */
    while (t < 200.0 && (side > 0.0 ? p->psi * exp(z[1]) < 40.0 : z[1] > -34.0))
        gsl_odeiv2_evolve_apply(evolve, control, step, &sys, &t, 200.0, &h, z);
    gsl_odeiv2_evolve_free(evolve);
    gsl_odeiv2_control_free(control);
    gsl_odeiv2_step_free(step);
}

struct plain_answer plain_branches(struct plain *p, double tol)
{
    double up[3], low[3];

    p->calls = 0;
    branch(p, 1.0, tol, up);
    branch(p, -1.0, tol, low);
    return (struct plain_answer){ p->v * exp(up[0]), p->v * exp(low[0]),
                                  -up[2] };
}
