#include "cvode_cell.h"

#ifndef HAVE_SUNDIALS

bool cvode_is_there(void)
{
    return false;
}

int cvode_label(struct plain *p, const double z[2])
{
    (void) p, (void) z;
    return -1;
}

bool cvode_cell(struct plain *p, const double z[2], const struct cvode_end *end,
                double tol, double slip_least, double *slip, double *time)
{
    (void) p, (void) z, (void) end, (void) tol, (void) slip_least;
    (void) slip, (void) time;
    return false;
}

#else

#include <cvode/cvode.h>
#include <math.h>
#include <nvector/nvector_serial.h>
#include <stdio.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

#include "fate.h"

bool cvode_is_there(void)
{
    return true;
}

static int rhs(realtype t, N_Vector y, N_Vector dy, void *ctx)
{
    const double *z = N_VGetArrayPointer(y);
    double *d = N_VGetArrayPointer(dy), f[2];
    const double large = exp(plain_field(ctx, z[0], z[1], f));

    (void) t;
    d[0] = f[0] * large;
    d[1] = f[1] * large;
    return isfinite(d[0]) && isfinite(d[1]) ? 0 : 1;
}

/* Where the orbit hardly moves any more it has arrived: left or right of the
 * saddle? */
static int arrived(struct plain *p, const double z[2])
{
    double f[2];
    const double large = exp(plain_field(p, z[0], z[1], f));
    const double v = p->v * exp(z[0]);
    const double rate = fmax(fabs(f[0]), fabs(f[1])) * large;

    if (hypot(z[0], z[1]) < 1.0 || rate > 1e-4 * fmax(v, 1.0))
        return -1;
    return z[0] < 0.0 ? FATE_CREEP : FATE_SLIDING;
}

int cvode_label(struct plain *p, const double z[2])
{
    static SUNContext context;
    if (context == NULL && SUNContext_Create(NULL, &context) != 0)
        return -1;
    N_Vector y = N_VNew_Serial(2, context);
    SUNMatrix A = SUNDenseMatrix(2, 2, context);
    SUNLinearSolver solver = SUNLinSol_Dense(y, A, context);
    void *cv = CVodeCreate(CV_BDF, context);
    double *u = N_VGetArrayPointer(y), d[2], t = 0.0;
    int label = -1;

    u[0] = z[0];
    u[1] = z[1];
    const double large = exp(plain_field(p, z[0], z[1], d));
    const double rate = large * (fabs(d[0]) + fabs(d[1])) + 1e5;
    CVodeInit(cv, rhs, 0.0, y);
    CVodeSStolerances(cv, 1e-6, 1e-6);
    CVodeSetUserData(cv, p);
    CVodeSetLinearSolver(cv, solver, A);
    CVodeSetInitStep(cv, 1e-3 / rate);
    CVodeSetMaxNumSteps(cv, 100000);
    CVodeSetErrFile(cv, NULL);
    for (int n = 0; n < 100000 && label < 0; n++) {
        if (CVode(cv, 1e6, y, &t, CV_ONE_STEP) < 0 || t >= 1e6)
            break;
        label = arrived(p, u);
    }
    CVodeFree(&cv);
    SUNLinSolFree(solver);
    SUNMatDestroy(A);
    N_VDestroy(y);
    return label;
}

struct cell_run {
    struct plain *plain;
    const struct cvode_end *end;
};

static int cell_rhs(realtype t, N_Vector y, N_Vector dy, void *ctx)
{
    const struct cell_run *r = ctx;
    const double *z = N_VGetArrayPointer(y);
    double *d = N_VGetArrayPointer(dy);

    if (rhs(t, y, dy, r->plain) != 0)
        return 1;
    d[2] = r->plain->v * exp(z[0]);
    return 0;
}

static int cell_root(realtype t, N_Vector y, realtype *g, void *ctx)
{
    const struct cell_run *r = ctx;
    const double *z = N_VGetArrayPointer(y);

    (void) t;
    g[0] = r->end->rests
               ? z[0] + 12.0
               : fmax(fabs(z[0] - r->end->x), fabs(z[1] - r->end->y)) - 0.01;
    return 0;
}

bool cvode_cell(struct plain *p, const double z[2], const struct cvode_end *end,
                double tol, double slip_least, double *slip, double *time)
{
    static SUNContext context;
    if (context == NULL && SUNContext_Create(NULL, &context) != 0)
        return false;
    struct cell_run run = { p, end };
    N_Vector y = N_VNew_Serial(3, context), least = N_VNew_Serial(3, context);
    SUNMatrix A = SUNDenseMatrix(3, 3, context);
    SUNLinearSolver solver = SUNLinSol_Dense(y, A, context);
    void *cv = CVodeCreate(CV_BDF, context);
    double *u = N_VGetArrayPointer(y), *l = N_VGetArrayPointer(least), d[2];

    u[0] = z[0];
    u[1] = z[1];
    u[2] = 0.0;
    l[0] = l[1] = tol;
    l[2] = tol * slip_least;
    const double large = exp(plain_field(p, z[0], z[1], d));
    const double rate = large * (fabs(d[0]) + fabs(d[1])) + 1e5;
    CVodeInit(cv, cell_rhs, 0.0, y);
    CVodeSVtolerances(cv, tol, least);
    CVodeSetUserData(cv, &run);
    CVodeSetLinearSolver(cv, solver, A);
    CVodeSetInitStep(cv, 1e-3 / rate);
    CVodeSetMaxNumSteps(cv, 50000);
    CVodeSetErrFile(cv, NULL);
    CVodeRootInit(cv, 1, cell_root);
    const bool good = CVode(cv, 1e9, y, time, CV_NORMAL) == CV_ROOT_RETURN;
    *slip = u[2];
    if (good && end->rests) { /* v falls at an even rate from here */
        const double faster = exp(plain_field(p, u[0], u[1], d));
        const double left = 1.0 / (fabs(d[0]) * faster);
        *time += left;
        *slip += 0.5 * p->v * exp(u[0]) * left;
    }
    CVodeFree(&cv);
    SUNLinSolFree(solver);
    SUNMatDestroy(A);
    N_VDestroy(y);
    N_VDestroy(least);
    return good;
}

#endif
