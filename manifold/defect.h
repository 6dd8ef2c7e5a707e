/*
 * defect.h -- how far a branch's polynomials are from the manifold.
 *
 * With the manifold as the graph dep(ind) and S = f_dep/f_ind its slope, the
 * error e of a polynomial p(ind), and what rounding makes of it, obeys
 *     |e|' <= S_dep |e| + |p' - S| + |rounding of S|
 * to first order; along most of a stable manifold S_dep < 0, and errors fade.
 * What the saddle's own place is off does not: it is the effect of a force that
 * is there everywhere, and stays, or grows where S_dep > 0.
 */
#pragma once

#include "branch.h"

/* Bounds on the error of dep at fixed ind. */
struct defect {
    double curve;  /* of the polynomials, and rounding */
    double saddle; /* for that of the saddle */
};

/* The field's slope at a point of a branch. */
struct defect_slope {
    int ind;               /* 0: y(x); 1: x(y) */
    double slope;          /* S */
    double by_ind, by_dep; /* its derivatives */
    double rounding;       /* bound on what S is off */
};

/* At theta on a piece. */
struct defect_slope defect_look(const struct planar *sys,
                                const struct branch *b, size_t piece,
                                double theta);

/* At the saddle, whose place is known to `floor`. */
struct defect defect_start(const struct branch *b, struct vec2 floor);

/* From the start of a piece, over its own ind, to theta. */
struct defect defect_carry(const struct planar *sys, const struct branch *b,
                           size_t piece, double theta, struct defect from);
