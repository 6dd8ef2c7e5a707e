/*
 * stress_truth.h -- what is true of a slope, by the 113-bit oracle alone: its
 * own saddle, from the signs of mu_ss - tan(alpha) at the turning points of
 * mu_ss, its own branches, its own eigenvalues.
 */
#pragma once

#include <stdint.h>

#include "fate.h"
#include "quad_branch.h"

/* The numbers of a slope that 113 bits can confirm. */
enum stress_number {
    STRESS_V_SP,
    STRESS_PSI_SP,
    STRESS_LAMBDA_MINUS,
    STRESS_LAMBDA_PLUS,
    STRESS_V_PLUS,
    STRESS_LN_V_PLUS,
    STRESS_V_MINUS,
    STRESS_LN_V_MINUS,
    STRESS_PSI_AT_V0,
    STRESS_X_EXCESS,
    STRESS_X_DEFICIT,
    STRESS_MU_S_NUM,
    STRESS_MU_S_MEAN,
    STRESS_FRACTURE_ENERGY,
    STRESS_KNEE_UPPER_V, /* the first ones */
    STRESS_KNEE_UPPER_PSI,
    STRESS_KNEE_LOWER_V,
    STRESS_KNEE_LOWER_PSI,
    STRESS_NUMBERS
};

struct stress_true {
    bool exists;
    quad value;
    quad error; /* of the oracle itself, absolute */
};

struct stress_knee {
    struct stress_true v, psi;
};

struct stress_truth {
    struct law law;
    bool saddle, below, above;   /* a steady state below, above the saddle */
    int8_t upper_end, lower_end; /* enum end_code; -1: no saddle, or unknown */
    struct stress_true number[STRESS_NUMBERS];
    struct quad_anchor at; /* of the saddle */
    struct quad_branch upper, lower;
    size_t evaluations;
};

/* The saddle within v = 1e-300...1e300 and, if it exists, all that follows;
 * bounded work: some seconds at most. */
void stress_truth_find(const struct law *law, const struct material *m,
                       long double tan_alpha, struct stress_truth *out);

/* The place of a crossing on one of t's branches. */
struct stress_knee stress_truth_knee(const struct stress_truth *t,
                                     const struct quad_knee *k);

/* On which side of the stable manifold the chart point (x, y) lies, as far as
 * the ends of its branches tell; `x` and `y` are absolute. */
enum stress_side { STRESS_STOPS, STRESS_SLIDES, STRESS_UNTOLD };
enum stress_side stress_truth_side(const struct stress_truth *t, quad x,
                                   quad y);

/* The fates (bits 1 << enum fate) that are right on that side; all of them
 * where it is untold.  t: of law and m. */
unsigned stress_truth_fates(const struct stress_truth *t, const struct law *law,
                            const struct material *m, enum stress_side side);
