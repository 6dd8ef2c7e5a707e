/*
 * estimates.h -- the analytic estimates of Putelat & Dawes 2015, section 4,
 * computed as printed: log form, c = 0, whatever the law's own form and c.
 * They exist for hyperbolic kinetics with theta a logarithm of psi and b > a.
 * Dimensionless; angles in rad.  NaN stands for "no such root" and is the only
 * NaN here: the caller turns it into a reason.
 */
#pragma once

#include "law.h"

struct estimates {
    double eta;
    double v_sp0, psi_sp0; /* (29) */
    double ln_v_sp0;
    double x_k;            /* (30): 2 eta atanh(exp(-psi_sp0)) */
    double x_k_small_psi;  /* (31): small psi_sp0 */
    double x_k_zero_slope; /* (31) at alpha = 0 */
    double alpha_f;        /* (42) with e = 1e-16 */
    double tan_alpha_f; /* what (43) should print: it prints the arctangent */
};

/* False, with *e undefined, where the estimates do not exist. */
bool estimates_at(const struct law *law, const struct material *m,
                  double tan_alpha, struct estimates *e);

/* Roots of chi(v) = 1, (34), as ln(v/v_sp0), ascending: none or two.  Their
 * errors hold what rounding does and what ln v_sp0, `unsure` by so much, does
 * to ln(v/v_sp0).  v_sp0 and psi_sp0 must be in the range of doubles; the
 * smaller v_sp0, the nearer the roots are, about v_sp0 |ln chi(v_sp0)|. */
struct estimates_root {
    double x, error;
};
size_t estimates_chi(const struct material *m, const struct estimates *e,
                     double tan_alpha, double unsure,
                     struct estimates_root root[2]);

/* The eigen-coordinate estimate (38), (39): ln(v/v_sp0) of the first points
 * outward on Y = 0 where dY/dX = -xi, 0 < xi < 1, below and above v_sp0; NaN
 * where there is none further than 1e-6 from the saddle (nearer ones say
 * nothing: there the manifold is a vertical wall). */
struct estimates_xi {
    double minus, plus;
};
struct estimates_xi estimates_xi_at(const struct material *m,
                                    const struct estimates *e, double tan_alpha,
                                    double xi);

/* (41) and (32) from ln(v_plus/v_sp): mu_s and G. */
struct estimates_strength {
    double mu_s, G;
};
struct estimates_strength estimates_strength_at(const struct material *m,
                                                double tan_alpha, double v_sp,
                                                double x_k, double ln_ratio);

/* (30) for any psi_sp. */
double estimates_persistence(double eta, double psi_sp);
