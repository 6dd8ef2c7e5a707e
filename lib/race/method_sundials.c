#include "method.h"

#ifndef HAVE_SUNDIALS

const struct method method_sundials[] = { { .name = NULL } };

const char *method_sundials_version(void)
{
    return "none";
}

#else

#include <arkode/arkode_erkstep.h>
#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <stdlib.h>
#include <string.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

/* Steps are bounded by our own count of calls. */
enum { STEPS = 100000000, ORDER = 8 };

struct run {
    struct method_system *system;
    const struct method *method;
    SUNContext context; /* owned, like all below */
    N_Vector u;
    SUNMatrix A;              /* BDF only */
    SUNLinearSolver solver;   /* BDF only */
    SUNNonlinearSolver fixed; /* Adams only */
    void *memory;             /* of CVODE or ARKODE */
};

static const int adams = CV_ADAMS, bdf = CV_BDF, explicit_rk = 0;

static bool is_arkode(const struct run *r)
{
    return r->method->kind == &explicit_rk;
}

/* Enough calls: stop; not finite: try a shorter step. */
static int refusal(const struct method_system *system)
{
    return system->calls > system->calls_most ? -1 : 1;
}

static int rates(realtype s, N_Vector u, N_Vector du, void *ctx)
{
    (void) s;
    return method_rates(ctx, N_VGetArrayPointer(u), N_VGetArrayPointer(du)) ? 0
                                                                            : 1;
}

static int jacobian(realtype s, N_Vector u, N_Vector f, SUNMatrix J, void *ctx,
                    N_Vector a, N_Vector b, N_Vector c)
{
    struct method_system *system = ctx;
    double row[METHOD_DIM * METHOD_DIM];

    (void) s, (void) f, (void) a, (void) b, (void) c;
    if (!method_jacobian(system, N_VGetArrayPointer(u), row))
        return refusal(system);
    for (size_t i = 0; i < system->dim; i++)
        for (size_t j = 0; j < system->dim; j++)
            SM_ELEMENT_D(J, i, j) = row[i * system->dim + j];
    return 0;
}

static void close(void *state)
{
    struct run *r = state;

    if (r->memory && is_arkode(r))
        ERKStepFree(&r->memory);
    else if (r->memory)
        CVodeFree(&r->memory);
    if (r->fixed)
        SUNNonlinSolFree(r->fixed);
    if (r->solver)
        SUNLinSolFree(r->solver);
    if (r->A)
        SUNMatDestroy(r->A);
    if (r->u)
        N_VDestroy(r->u);
    SUNContext_Free(&r->context);
    free(r);
}

static bool open_arkode(struct run *r, double tol, double h)
{
    r->memory = ERKStepCreate(rates, 0.0, r->u, r->context);
    return r->memory && ERKStepSetOrder(r->memory, ORDER) == 0 &&
           ERKStepSStolerances(r->memory, tol, tol) == 0 &&
           ERKStepSetUserData(r->memory, r->system) == 0 &&
           ERKStepSetErrFile(r->memory, NULL) == 0 &&
           ERKStepSetMaxNumSteps(r->memory, STEPS) == 0 &&
           ERKStepSetInitStep(r->memory, h) == 0;
}

/* As the manual has it: Newton's method for BDF, none for Adams. */
static bool set_solver(struct run *r)
{
    const sunindextype n = (sunindextype) r->system->dim;

    if (r->method->kind == &adams) {
        r->fixed = SUNNonlinSol_FixedPoint(r->u, 0, r->context);
        return r->fixed && CVodeSetNonlinearSolver(r->memory, r->fixed) == 0;
    }
    r->A = SUNDenseMatrix(n, n, r->context);
    if (r->A)
        r->solver = SUNLinSol_Dense(r->u, r->A, r->context);
    return r->solver && CVodeSetLinearSolver(r->memory, r->solver, r->A) == 0 &&
           CVodeSetJacFn(r->memory, jacobian) == 0;
}

static bool open_cvode(struct run *r, double tol, double h)
{
    r->memory = CVodeCreate(*(const int *) r->method->kind, r->context);
    return r->memory && CVodeInit(r->memory, rates, 0.0, r->u) == 0 &&
           CVodeSStolerances(r->memory, tol, tol) == 0 &&
           CVodeSetUserData(r->memory, r->system) == 0 &&
           CVodeSetErrFile(r->memory, NULL) == 0 &&
           CVodeSetMaxNumSteps(r->memory, STEPS) == 0 &&
           CVodeSetInitStep(r->memory, h) == 0 && set_solver(r);
}

static void *open(const struct method *m, struct method_system *system,
                  double tol, const double u[], double h)
{
    struct run *r = calloc(1, sizeof *r);

    if (r == NULL)
        return NULL;
    r->system = system;
    r->method = m;
    bool good = SUNContext_Create(NULL, &r->context) == 0;
    if (good)
        r->u = N_VNew_Serial((sunindextype) system->dim, r->context);
    good = good && r->u;
    if (good)
        memcpy(N_VGetArrayPointer(r->u), u, system->dim * sizeof *u);
    if (good && (is_arkode(r) ? open_arkode(r, tol, h) : open_cvode(r, tol, h)))
        return r;
    close(r);
    return NULL;
}

static bool step(void *state, double s_end, double *s, double u[])
{
    struct run *r = state;
    const bool ark = is_arkode(r);

    if ((ark ? ERKStepSetStopTime(r->memory, s_end)
             : CVodeSetStopTime(r->memory, s_end)) != 0)
        return false;
    const int flag =
        ark ? ERKStepEvolve(r->memory, s_end, r->u, s, ARK_ONE_STEP)
            : CVode(r->memory, s_end, r->u, s, CV_ONE_STEP);
    memcpy(u, N_VGetArrayPointer(r->u), r->system->dim * sizeof *u);
    return flag >= 0;
}

static bool between(void *state, double s, double u[])
{
    struct run *r = state;
    N_Vector at = N_VMake_Serial((sunindextype) r->system->dim, u, r->context);

    if (at == NULL)
        return false;
    const int flag = is_arkode(r) ? ERKStepGetDky(r->memory, s, 0, at)
                                  : CVodeGetDky(r->memory, s, 0, at);
    N_VDestroy(at);
    return flag == 0;
}

#define SUNDIALS(name_, text_, kind_)                                          \
    {                                                                          \
        .name = name_, .text = "SUNDIALS' " text_, .foreign = true,            \
        .kind = &kind_, .open = open, .step = step, .between = between,        \
        .close = close                                                         \
    }

const struct method method_sundials[] = {
    SUNDIALS("cvode_adams", "Adams-Moulton methods of CVODE", adams),
    SUNDIALS("cvode_bdf", "backward differences of CVODE", bdf),
    SUNDIALS("arkode_erk8", "explicit Fehlberg method of order 8 of ARKODE",
             explicit_rk),
    { .name = NULL },
};

const char *method_sundials_version(void)
{
    return SUNDIALS_VERSION;
}

#endif
