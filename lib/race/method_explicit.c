/* Changed against the book: a step counts as accepted only when its dense
 * output is finite too, for others look between its ends. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "control.h"
#include "explicit8.h"
#include "method.h"
#include "tolerance.h"

enum { COEFS = EXPLICIT8_DEGREE + 1 };

struct run {
    struct method_system *system;
    struct ode ode;
    struct explicit8 work;
    struct control control;
    double tol[METHOD_DIM], h; /* the size of the next step */
    double from, s;            /* the last step */
    double u[METHOD_DIM], coef[METHOD_DIM * COEFS];
};

static void rates(const void *ctx, double s, const double u[], double du[])
{
    const struct run *r = ctx;

    (void) s;
    if (!method_rates(r->system, u, du))
        du[0] = (double) NAN;
}

static void *open(const struct method *m, struct method_system *system,
                  double tol, const double u[], double h)
{
    struct run *r = calloc(1, sizeof *r);

    (void) m;
    if (r == NULL)
        return NULL;
    r->system = system;
    r->ode = (struct ode){ system->dim, rates, r };
    r->control = CONTROL_INIT(8.0);
    r->h = h;
    for (size_t i = 0; i < system->dim; i++)
        r->tol[i] = tol;
    memcpy(r->u, u, system->dim * sizeof *u);
    rates(r, 0.0, u, r->work.k[0]);
    return r;
}

/* Whether the step of size h is accepted, to u1. */
static bool is_good(struct run *r, double h, double u1[])
{
    double error[METHOD_DIM], factor;
    double off = explicit8_try(&r->work, &r->ode, r->s, r->u, h, r->tol,
                               r->tol[0], u1, error);

    if (off <= 1.0) {
        explicit8_dense(&r->work, &r->ode, r->s, r->u, h, u1, r->coef);
        if (!ode_all_finite(r->coef, r->ode.dim * COEFS))
            off = INFINITY;
    }
    const bool good = control_judge(&r->control, off, &factor);
    r->h = fabs(h) * factor;
    return good;
}

static bool step(void *state, double s_end, double *s, double u[])
{
    struct run *r = state;
    const size_t size = r->ode.dim * sizeof *u;
    double u1[METHOD_DIM], h;
    bool last;

    do {
        const double way = s_end - r->s;
        last = !(1.01 * r->h < fabs(way));
        h = last ? way : copysign(r->h, way);
        if (!(fabs(h) > TOL_STEP_MIN) || (!last && r->s + h == r->s))
            return false;
    } while (!is_good(r, h, u1));
    r->from = r->s;
    r->s = *s = last ? s_end : r->s + h;
    memcpy(r->u, u1, size);
    memcpy(u, u1, size);
    memcpy(r->work.k[0], r->work.k[EXPLICIT8_CALLS + 1], size);
    return true;
}

static bool between(void *state, double s, double u[])
{
    const struct run *r = state;
    const double theta = (s - r->from) / (r->s - r->from);

    for (size_t i = 0; i < r->ode.dim; i++) {
        const double *c = r->coef + i * COEFS;
        u[i] = c[COEFS - 1];
        for (int j = COEFS - 1; j-- > 0;)
            u[i] = u[i] * theta + c[j];
    }
    return true;
}

const struct method method_explicit[] = {
    { .name = "explicit8",
      .text = "our Dormand-Prince method of order 8 (explicit8.h)",
      .open = open,
      .step = step,
      .between = between,
      .close = free },
    { .name = NULL },
};
