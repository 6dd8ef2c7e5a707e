#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "flow.h"
#include "method.h"
#include "tolerance.h"

struct run {
    struct method_system *system;
    struct ode ode;
    struct flow flow; /* owned */
    double s;         /* where the last step began */
};

static void rates(const void *ctx, double s, const double u[], double du[])
{
    const struct run *r = ctx;

    (void) s;
    if (!method_rates(r->system, u, du))
        du[0] = (double) NAN;
}

static void close(void *state)
{
    struct run *r = state;

    flow_free(&r->flow);
    free(r);
}

static void *open(const struct method *m, struct method_system *system,
                  double tol, const double u[], double h)
{
    struct run *r = calloc(1, sizeof *r);
    struct flow_options o = { .rtol = tol,
                              .first_step = h,
                              .max_steps = 16 * TOL_ORBIT_STEPS };

    (void) m;
    if (r == NULL)
        return NULL;
    for (size_t i = 0; i < system->dim; i++)
        o.atol[i] = tol;
    r->system = system;
    r->ode = (struct ode){ system->dim, rates, r };
    if (flow_init(&r->flow, &r->ode, 0.0, u, &o) == STATUS_OK)
        return r;
    close(r);
    return NULL;
}

static bool step(void *state, double s_end, double *s, double u[])
{
    struct run *r = state;

    r->s = r->flow.s;
    if (flow_step(&r->flow, s_end) != STATUS_OK)
        return false;
    *s = r->flow.s;
    memcpy(u, r->flow.u, r->ode.dim * sizeof *u);
    return true;
}

static bool between(void *state, double s, double u[])
{
    const struct run *r = state;
    const double way = r->flow.s - r->s;

    curve_at(&r->flow.curve, r->flow.curve.count - 1, (s - r->s) / way, u);
    return true;
}

const struct method method_flow[] = {
    { .name = "explicit8",
      .text = "our Dormand-Prince method of order 8 (flow.h)",
      .open = open,
      .step = step,
      .between = between,
      .close = close },
    { .name = NULL },
};
