/*
 * bench_manifold -- both branches, v_plus, v_minus and x_excess with their
 * bars, against what a careful user writes with GSL: rk8pd on unit arc length
 * in (ln v, ln psi), saddle-centred, x_excess as a third component.
 * Generalised Dieterich law, Table 2.  Prints times and ratios of one run;
 * a ratio below 1 means that Slipway is faster.
 */
#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>
#include <math.h>
#include <stdio.h>
#include <time.h>

#include "numbers.h"

enum { REPEATS = 15, INNER = 40 };

static double now(void)
{
    struct timespec t;

    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double) t.tv_sec + 1e-9 * (double) t.tv_nsec;
}

/* ---- the user's programme -------------------------------------------------
 */

struct plain {
    double a, b, A; /* A = cos(alpha)/(eps^2 v_sp) */
    double v, psi;  /* saddle */
    double s0;      /* asinh form; 0: log form */
    double lambda;  /* stable eigenvalue */
    size_t calls;
};

static double plain_mu(const struct plain *p, double X, double Y)
{
    const double mu = p->a * X + p->b * Y;

    if (p->s0 == 0.0)
        return mu;
    const double q = p->s0 * p->s0 - 1.0;
    const double s = sqrt(1.0 + q * exp(-2.0 * mu / p->a));
    return mu + p->a * log1p(q * expm1(-2.0 * mu / p->a) / (s + p->s0) /
                             (1.0 + p->s0));
}

static int plain_rhs(double t, const double z[], double d[], void *ctx)
{
    struct plain *p = ctx;
    const double X = z[0], Y = z[1];
    const double D = p->psi * (expm1(Y) - expm1(-X)), shrink = exp(-fabs(D));
    const double K = -0.5 * copysign(1.0, D) * expm1(-2.0 * fabs(D));
    const double fx = -p->A * plain_mu(p, X, Y) * exp(-X) * shrink;
    const double fy = -K * p->v / p->psi * exp(X - Y);
    const double n = -hypot(fx, fy); /* backward in time */

    (void) t;
    p->calls++;
    d[0] = fx / n;
    d[1] = fy / n;
    d[2] = p->v * expm1(X) * shrink / n;
    return GSL_SUCCESS;
}

struct answer {
    double v_plus, v_minus, x_excess;
    size_t calls;
};

/* One branch to psi = 40 or ln(psi/psi_sp) = -34, where nothing changes. */
static void plain_branch(struct plain *p, struct vec2 e, double side,
                         double tol, double z[3])
{
    gsl_odeiv2_system sys = { plain_rhs, NULL, 3, p };
    gsl_odeiv2_step *step = gsl_odeiv2_step_alloc(gsl_odeiv2_step_rk8pd, 3);
    gsl_odeiv2_control *control = gsl_odeiv2_control_y_new(tol, tol);
    gsl_odeiv2_evolve *evolve = gsl_odeiv2_evolve_alloc(3);
    const double start = tol < 1e-9 ? 1e-6 : 1e-4;
    double t = 0.0, h = 1e-3;

    z[0] = side * start * e.x;
    z[1] = side * start * e.y;
    z[2] = p->v * z[0] / p->lambda; /* from the saddle to here */
    while (t < 200.0 && (side > 0.0 ? p->psi * exp(z[1]) < 40.0 : z[1] > -34.0))
        gsl_odeiv2_evolve_apply(evolve, control, step, &sys, &t, 200.0, &h, z);
    gsl_odeiv2_evolve_free(evolve);
    gsl_odeiv2_control_free(control);
    gsl_odeiv2_step_free(step);
}

static struct answer plain_answer(const struct block *b,
                                  const struct equilibrium *e, double tol)
{
    const bool log_form = b->law.form == FRICTION_LOG;
    struct plain p = { .a = b->at.a,
                       .b = b->at.b,
                       .A = exp(b->at.log_inertia),
                       .v = b->at.v0,
                       .psi = b->at.psi0,
                       .lambda = e->lambda[0],
                       .s0 = log_form ? 0.0 : sqrt(1.0 + b->at.q0) };
    const struct vec2 u = mat2_eigenvector(e->matrix, e->scaled[0]);
    double up[3], low[3];

    plain_branch(&p, u, 1.0, tol, up);
    plain_branch(&p, u, -1.0, tol, low);
    return (struct answer){ p.v * exp(up[0]), p.v * exp(low[0]), -up[2],
                            p.calls };
}

/* ---- ours ------------------------------------------------------------------
 */

static struct answer our_answer(struct block *b, double rtol, bool all)
{
    struct planar sys = block_planar(b);
    struct steady_root root[EQUILIBRIA_MAX];
    struct grow_options o = grow_defaults(rtol);
    struct branch branch[2];
    struct equilibrium e;
    struct local_series u;

    equilibrium_find(&sys, root);
    block_anchor(b, root[0].x, true);
    sys = block_planar(b);
    equilibrium_at(&sys, false, &e);
    o.carry = (struct carry){ { BLOCK_EXCESS }, 1 };
    if (local_at(&sys, &e, MANIFOLD_STABLE, &o.carry, o.order, 0.01 * rtol,
                 &u) != STATUS_OK ||
        grow_branch(&sys, &u, 1, &o, &branch[0]) != STATUS_OK ||
        grow_branch(&sys, &u, -1, &o, &branch[1]) != STATUS_OK)
        return (struct answer){ NAN, NAN, NAN, 0 };
    struct critical_numbers n = numbers_critical(b, &e, &branch[0], &branch[1]);
    if (all)
        numbers_knees(b, &sys, &branch[0], &branch[1], &n);
    branch_free(&branch[0]);
    branch_free(&branch[1]);
    return (struct answer){ n.v_plus.value, n.v_minus.value, n.x_excess.value,
                            branch[0].evaluations + branch[1].evaluations };
}

/* ---- the race ---------------------------------------------------------------
 */

static double worst(struct answer a, struct answer exact)
{
    return fmax(fabs(a.v_plus / exact.v_plus - 1.0),
                fmax(fabs(a.v_minus / exact.v_minus - 1.0),
                     fabs(a.x_excess / exact.x_excess - 1.0)));
}

static void race(enum friction_form form, double alpha, double accuracy)
{
    struct law law = *law_preset_find("dieterich_gen");
    const struct material m = material_bristol_board();
    struct block b;
    double user = HUGE_VAL, ours = HUGE_VAL, full = HUGE_VAL, tol = accuracy;
    struct equilibrium e;

    law.form = form;
    block_init(&b, &law, &m, tanl((long double) alpha));
    const struct answer exact = our_answer(&b, 1e-13, false);
    struct planar sys = block_planar(&b);
    equilibrium_at(&sys, false, &e);
    struct answer theirs = plain_answer(&b, &e, tol);
    for (int i = 0; i < 12 && worst(theirs, exact) > accuracy; i++)
        theirs = plain_answer(&b, &e, tol *= 0.5);
    for (int r = 0; r < REPEATS; r++) {
        double t = now();
        for (int i = 0; i < INNER; i++)
            theirs = plain_answer(&b, &e, tol);
        user = fmin(user, (now() - t) / INNER);
        t = now();
        for (int i = 0; i < INNER; i++)
            our_answer(&b, accuracy, false);
        ours = fmin(ours, (now() - t) / INNER);
        t = now();
        for (int i = 0; i < INNER; i++)
            our_answer(&b, accuracy, true);
        full = fmin(full, (now() - t) / INNER);
    }
    printf("%-5s %.2f %-7.0e %8.1f %9.1e %6zu %8.1f %9.1e %8.2f %8.2f\n",
           friction_form_names[form], alpha, accuracy, 1e6 * user,
           worst(theirs, exact), theirs.calls, 1e6 * ours,
           worst(our_answer(&b, accuracy, false), exact), ours / user,
           full / user);
}

int main(void)
{
    static const double alpha[] = { 0.30, 0.34, 0.38 };

    printf("form  alpha accuracy  GSL us   error   calls  ours us   error  "
           "ratio  with knees\n");
    for (int form = FRICTION_LOG; form >= FRICTION_ASINH; form--)
        for (int i = 0; i < 3; i++) {
            race((enum friction_form) form, alpha[i], 1e-12);
            race((enum friction_form) form, alpha[i], 1e-6);
        }
    return 0;
}
