#include "method.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>
#include <stdlib.h>
#include <string.h>

struct run {
    struct method_system *system;
    gsl_odeiv2_system sys;
    gsl_odeiv2_driver *driver; /* owned */
    gsl_odeiv2_driver *again;  /* owned; for parts of the last step */
    double s, u[METHOD_DIM];   /* where the last step began */
};

/* Enough calls: stop; not finite: try a shorter step. */
static int refusal(const struct method_system *system)
{
    return system->calls > system->calls_most ? GSL_EBADFUNC : GSL_EDOM;
}

static int rates(double s, const double u[], double du[], void *ctx)
{
    (void) s;
    return method_rates(ctx, u, du) ? GSL_SUCCESS : refusal(ctx);
}

static int jacobian(double s, const double u[], double *J, double dfds[],
                    void *ctx)
{
    struct method_system *system = ctx;

    (void) s;
    memset(dfds, 0, system->dim * sizeof *dfds);
    return method_jacobian(system, u, J) ? GSL_SUCCESS : refusal(system);
}

static void close(void *state)
{
    struct run *r = state;

    if (r->driver)
        gsl_odeiv2_driver_free(r->driver);
    if (r->again)
        gsl_odeiv2_driver_free(r->again);
    free(r);
}

/* The type of GSL's that a method is. */
static const gsl_odeiv2_step_type *type_of(const struct method *m)
{
    return *(const gsl_odeiv2_step_type *const *) m->kind;
}

static void *open(const struct method *m, struct method_system *system,
                  double tol, const double u[], double h)
{
    struct run *r = calloc(1, sizeof *r);

    (void) u;
    if (r == NULL)
        return NULL;
    r->system = system;
    r->sys = (gsl_odeiv2_system){ rates, jacobian, system->dim, system };
    r->driver = gsl_odeiv2_driver_alloc_y_new(&r->sys, type_of(m), h, tol, tol);
    if (m->between)
        r->again =
            gsl_odeiv2_driver_alloc_y_new(&r->sys, type_of(m), h, tol, tol);
    if (r->driver == NULL || (m->between && r->again == NULL)) {
        close(r);
        return NULL;
    }
    return r;
}

static bool step(void *state, double s_end, double *s, double u[])
{
    struct run *r = state;
    gsl_odeiv2_driver *d = r->driver;

    r->s = *s;
    memcpy(r->u, u, r->sys.dimension * sizeof *u);
    return gsl_odeiv2_evolve_apply(d->e, d->c, d->s, &r->sys, s, s_end, &d->h,
                                   u) == GSL_SUCCESS;
}

/* The step once more, only shorter. */
static bool between(void *state, double s, double u[])
{
    struct run *r = state;
    double error[METHOD_DIM];

    memcpy(u, r->u, r->sys.dimension * sizeof *u);
    gsl_odeiv2_step_reset(r->again->s);
    return gsl_odeiv2_step_apply(r->again->s, r->s, s - r->s, u, error, NULL,
                                 NULL, &r->sys) == GSL_SUCCESS;
}

#define GSL(name_, text_, between_)                                            \
    {                                                                          \
        .name = "gsl_" #name_, .text = "GSL's " text_, .foreign = true,        \
        .kind = &gsl_odeiv2_step_##name_, .open = open, .step = step,          \
        .between = between_, .close = close                                    \
    }

const struct method method_gsl[] = {
    GSL(rk8pd, "explicit Prince-Dormand method of order 8", between),
    GSL(rkf45, "explicit Fehlberg method of order 4", between),
    GSL(msbdf, "backward differences in Nordsieck form", NULL),
    GSL(bsimp, "implicit extrapolation of Bader and Deuflhard", between),
    GSL(rk4imp, "implicit Gauss method of order 4", between),
    { .name = NULL },
};
