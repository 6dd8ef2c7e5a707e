/*
 * law_root.h -- psi_ss(v) of a law that people type as dpsi/dt alone: where
 * that is 0.
 */
#ifndef FRICTION_LAW_ROOT_H
#define FRICTION_LAW_ROOT_H

#include "law_graph.h"
#include "status.h"

/* The chart's y at x = ln v; NaN where dpsi/dt is 0 at no psi. */
long double law_root(struct law_long *p, long double x);
/* The same to 113 bits. */
formula_real law_root_quad(struct law_quad *p, formula_real x);

/* STATUS_BAD_SCENE with a reason where psi_ss is no function of v as far as a
 * search can tell: dpsi/dt is 0 at no psi, or at several, or psi leaves where
 * it is 0. */
MUST_CHECK enum status law_root_check(const struct law *law,
                                      const struct material *m,
                                      struct fault *why);

#endif
