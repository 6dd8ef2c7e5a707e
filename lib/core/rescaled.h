/*
 * rescaled.h -- a planar system on the clock
 *
 *     d tau = sqrt(kappa^2 + |f|^2) dt,
 *
 * which is arc length where the field f is fast and kappa t where it is slow:
 * |dz/dtau| <= 1 everywhere, equilibria stay equilibria, and tau is smooth.
 * Components: x, y, t, then the integrals of the first observables.
 */
#pragma once

#include "planar.h"
#include "radau.h"

struct rescaled {
    const struct planar *system; /* borrowed */
    double kappa;                /* > 0, per unit of time */
    size_t observables;          /* <= system->observable_count */
};

/* d(x, y, t, q...)/dtau at the offset z with the gradients; finite for log
 * scales of any size as long as directions and rates are. */
void rescaled_linear(const struct rescaled *r, struct vec2 z,
                     struct cascade_linear *out);

/* The largest entry of the Jacobian Df, per unit of time, of what
 * rescaled_linear gave. */
double rescaled_rate(const struct cascade_linear *l);

/* The same without, as the system of dimension 3 + observables that radau.h
 * integrates; borrows r. */
struct cascade rescaled_cascade(const struct rescaled *r);
