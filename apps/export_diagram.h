/* export_diagram.h -- the diagrams of steady sliding into an HDF5 file. */
#ifndef APPS_EXPORT_DIAGRAM_H
#define APPS_EXPORT_DIAGRAM_H

#include "store.h"
#include "study.h"

/* The layers of /chi. */
extern const struct record_type record_chi;

/*
 * What the study's stages hold of these (diagram.h), dimensionless but k:
 *   /friction_law   (v: psi, mu, slope), /friction_law/dieterich (the same),
 *                   /friction_law/extrema (n: kind, v, psi, mu, alpha)
 *   /spring_block   (v: k, k_quasistatic), /spring_block/dieterich, /extrema;
 *                   attributes sigma and mass
 *   /bifurcation    (v: alpha, type, psi, mu, lambda_minus, lambda_plus),
 *                   /bifurcation/folds (n: as extrema)
 *   /fold_curves    (c: alpha_cm, alpha_cM, v_m, v_M, mu_m, mu_M),
 *                   /fold_curves/cusp (c, v, psi, mu, alpha)
 *   /chi            (alpha: v_sp0, v_low, v_high; alpha x v: ln_chi,
 *                   ln_chi_error)
 * Sticks on failure, as store.h says.
 */
MUST_CHECK enum status export_diagrams(const struct study *s,
                                       struct store *out);

#endif
