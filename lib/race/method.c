#include "method.h"

#include <gsl/gsl_version.h>

#include "ode.h"

const struct method *method_at(size_t i)
{
    static const struct method *const table[] = { method_explicit, method_gsl,
                                                  method_sundials };

    for (size_t k = 0; k < sizeof table / sizeof *table; k++)
        for (const struct method *m = table[k]; m->name; m++)
            if (i-- == 0)
                return m;
    return NULL;
}

const char *method_gsl_version(void)
{
    return gsl_version;
}

bool method_rates(struct method_system *system, const double u[], double du[])
{
    if (++system->calls > system->calls_most)
        return false;
    system->rates(system->ctx, u, du);
    return ode_all_finite(du, system->dim);
}

bool method_jacobian(struct method_system *system, const double u[], double J[])
{
    if (++system->calls > system->calls_most)
        return false;
    system->jacobian(system->ctx, u, J);
    return ode_all_finite(J, system->dim * system->dim);
}
