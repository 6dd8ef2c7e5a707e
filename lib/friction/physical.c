#include "physical.h"

#include <math.h>

/* phi = unit * psi, or unit * e^psi. */
static double unit_of(const struct law *law, const struct material *m)
{
    const double time = m->L / m->V_star;

    switch (law->theta) {
        case THETA_LN_PSI:
            return time;
        case THETA_PSI:
            return law->kinetics == KINETICS_SINH ? 2.0 * time : time;
        case THETA_LN_C_PSI:
            return isfinite(m->R) ? 1.0 / (1.0 + m->R) : 1.0;
        default:
            return 1.0;
    }
}

double physical_phi(const struct law *law, const struct material *m, double psi)
{
    return unit_of(law, m) * (law_psi_is_log(law) ? exp(psi) : psi);
}

double physical_psi(const struct law *law, const struct material *m, double phi)
{
    const double psi = phi / unit_of(law, m);
    return law_psi_is_log(law) ? log(psi) : psi;
}

const char *physical_unit(const struct law *law)
{
    return law->theta == THETA_LN_PSI || law->theta == THETA_PSI ? "s" : "1";
}

struct unit_system physical_units(const struct law *law,
                                  const struct material *m, bool si)
{
    return (struct unit_system){ .si = si,
                                 .V_star = m->V_star,
                                 .L = m->L,
                                 .phi_1 = unit_of(law, m),
                                 .psi_is_log = law_psi_is_log(law),
                                 .phi = physical_unit(law) };
}
