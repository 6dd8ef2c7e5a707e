/* physical.h -- between the dimensionless state psi and the physical phi. */
#pragma once

#include "law.h"
#include "unit.h"

/* phi of psi: (L/V_star) psi in s for `dieterich*`,
 * (L/V_star) e^psi for `ruina`, (2 L/V_star) e^psi for `perrin`, psi/(1 + R)
 * for `spinodal`, `spinodal_gen`, psi for `spinodal_phi_gen`; composed laws as
 * the preset with the same theta (and, of `ruina` and `perrin`, kinetics). */
double physical_phi(const struct law *law, const struct material *m,
                    double psi);

/* The inverse, for phi > 0. */
double physical_psi(const struct law *law, const struct material *m,
                    double phi);

/* "s", or "1" where phi is dimensionless. */
const char *physical_unit(const struct law *law);

/* In which to tell numbers: the SI, or as they are. */
struct unit_system physical_units(const struct law *law,
                                  const struct material *m, bool si);
