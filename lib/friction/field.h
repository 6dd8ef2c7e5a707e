/*
 * field.h -- the block's vector field for the kinds of number the program
 * uses; see field_formula.h for the formulas and block.h for the system.
 */
#ifndef FRICTION_FIELD_H
#define FRICTION_FIELD_H

#include "anchor.h"
#include "planar.h"

/* Observables beyond time, in this order. */
enum block_observable {
    BLOCK_SLIP,   /* v: slip, units of L */
    BLOCK_WORK,   /* mu v: frictional work per normal force, units of L */
    BLOCK_EXCESS, /* v - v0: slip in excess of the anchor's, units of L */
    BLOCK_OBSERVABLES
};

void field_real(const struct law *law, const struct anchor *at, struct vec2 z,
                struct planar_field *f);

double field_real_rate(const struct law *law, const struct anchor *at,
                       enum block_observable which, struct vec2 z);

void field_dual(const struct law *law, const struct anchor *at, struct vec2 z,
                struct planar_jacobian *J);
void field_dual_rate(const struct law *law, const struct anchor *at,
                     enum block_observable which, struct vec2 z, double *rate,
                     struct vec2 *gradient);

/* Coefficient k: the contract of planar.jet and planar.rate_jet. */
void field_jet(const struct law *law, const struct anchor *at,
               struct jet_work *w, size_t k, const jet_pair x[],
               const jet_pair y[], jet_pair fx[], jet_pair fy[]);
void field_jet_rate(const struct law *law, const struct anchor *at,
                    enum block_observable which, struct jet_work *w, size_t k,
                    const jet_pair x[], const jet_pair y[], jet_pair rate[]);

#endif
