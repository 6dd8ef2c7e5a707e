/* proof_units.h -- enclosures of numbers told in the SI (unit.h). */
#pragma once

#include "interval.h"
#include "law.h"

/* What physical_units (physical.h) has, enclosed. */
struct proof_units {
    struct interval V_star, L, phi_1;
    bool psi_is_log;
};

/* V_star, L and R are the shortest decimals that read as these doubles. */
struct proof_units proof_units_of(const struct law *law,
                                  const struct material *m);

/* unit_value of a number in this unit, no angle and no kick. */
struct interval_double proof_in_si(const struct proof_units *u,
                                   const char *unit, struct interval_double x);
