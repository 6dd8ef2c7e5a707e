#include "cusp.h"

#include <math.h>

static struct cusp none(const char *reason)
{
    return (struct cusp){ .reason = reason };
}

struct cusp cusp_find(const struct law *law, const struct material *m)
{
    const long double a = (long double) m->a, b = (long double) m->b;
    const long double R = (long double) m->R, rise = b - a;
    const bool unit = law->psi_ss == PSI_SS_SPINODAL_UNIT;

    if (law->typed)
        return none("cusps of a law of formulas are not looked for");
    if (!law_uses(law, MATERIAL_C))
        return none("the law does not use c");
    if ((!unit && law->psi_ss != PSI_SS_SPINODAL) || isinf(m->R))
        return none("mu_ss has one extremum at most, whatever c is");
    if (!(rise > 0))
        return none("mu_ss has no extremum at any c: that needs b > a");
    const long double top_R = unit ? 1 : 1 + R;
    const long double scale = law->theta == THETA_LN_C_PSI ? 1 : 1 + R;
    return (struct cusp){
        .c = scale * top_R * rise * rise / (4 * a * b),
        .x = logl((a + b) / (rise * R)),
    };
}
