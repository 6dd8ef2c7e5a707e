#include "rabinowicz.h"

#include <math.h>

double rabinowicz_K(double block_mass, double ball_mass, double restitution)
{
    const double kick = (1.0 + restitution) * (ball_mass / block_mass);

    return 5.0 / 7.0 * kick * kick;
}

double rabinowicz_release(double eps2, double v, double K, double tan_alpha)
{
    const double sine = tan_alpha / hypot(1.0, tan_alpha);

    return eps2 * v * v / (2.0 * K * sine);
}

double rabinowicz_release_of_energy(double G, double K, double tan_alpha)
{
    return G / (K * tan_alpha);
}

double rabinowicz_mu_half(const struct material *m)
{
    return m->mu_star + (m->b - m->a) * M_LN2;
}

double rabinowicz_factor(const struct law *law, const struct material *m,
                         double K)
{
    return law_eta(law, m) * m->L / (K * (m->b - m->a));
}

double rabinowicz_release_33(double factor, double mu_s, double mu_half,
                             double tan_alpha)
{
    return factor * (mu_s - tan_alpha) * (mu_half - tan_alpha) / tan_alpha;
}
