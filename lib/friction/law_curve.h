/*
 * law_curve.h -- the steady states of a law of formulas at many v, and how they
 * change with x = ln v: what does not change with x is made once.
 */
#ifndef FRICTION_LAW_CURVE_H
#define FRICTION_LAW_CURVE_H

#include "law_typed.h"

struct typed_curve {
    const struct law *law;    /* borrowed */
    const struct material *m; /* borrowed */
    long double value[FORMULA_NODES], slope[FORMULA_NODES];
    formula_real exact[FORMULA_NODES], exact_slope[FORMULA_NODES];
    short changing[FORMULA_NODES], of_mu[FORMULA_NODES];
    int count, count_mu; /* of them */
    bool is_exact;       /* exact[] is made */
};

void law_curve_init(struct typed_curve *c, const struct law *law,
                    const struct material *m);

/* As law_typed_steady. */
struct typed_steady law_curve_at(struct typed_curve *c, long double x);

/* d(y, psi, mu)/dx of it. */
struct typed_steady law_curve_slopes(struct typed_curve *c, long double x);

/* d mu_ss/dx in 113 bits */
formula_real law_curve_slope(struct typed_curve *c, long double x);

#endif
